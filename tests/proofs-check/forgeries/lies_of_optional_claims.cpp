// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// About claims that may be left out: embedded, isotopic, stable, near.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "lies.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Are there triangles outside coarse tetrahedra?
bool has_bound(const Exhibit& e, const Json& level) {
  if (level["distance"].is_null()) return false;
  std::set<std::int64_t> coarse;
  for (const Json& t : level["distance"]["coarse"]) coarse.insert(t.get<std::int64_t>());
  const std::size_t first = level["triangles"][0], count = level["triangles"][1];
  for (std::size_t t = first; t < first + count; ++t)
    if (!coarse.contains(e.surface.tet[t])) return true;
  return false;
}

bool tell_distance(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!has_bound(e, level)) return false;
  Json& distance = level["distance"];
  Json& reach = distance["reach"];
  switch (pick.below(4)) {
    case 0:
      return distance["bound"] = "0x1p-900", true;
    case 1:
      if (distance["coarse"].empty()) return false;
      return distance["coarse_bound"] = "0x1p-900", true;
    case 2:
      return distance["coarse"].push_back(1000000), true;
    default:  // nearer than it is, all of it
      for (Json& n : reach) n = -400;
      return distance["bound"] = "0x1p-90", true;
  }
}

bool tell_reaches(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["distance"].is_null() || level["distance"]["reach"].empty()) return false;
  Json& reach = level["distance"]["reach"];
  if (pick.coin()) return reach.push_back(0), true;
  return reach.erase(pick.below(reach.size())), true;
}

/// That a component is in all fields within a radius, if there is one within that is isotropic.
bool tell_stable_component(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["components"].empty()) return false;
  const Json first = level["components"][pick.below(level["components"].size())]["first_vertex"];
  Json& claim = level["stability"] = {
      {"radius", "0x1p900"}, {"of", "tensor"}, {"components", Json::array({first})}};
  switch (pick.below(4)) {
    case 0:
      return true;
    case 1:
      return claim["radius"] = "0x1p0", claim["of"] = "deviator", true;
    case 2:  // of no component
      claim["radius"] = "0x0p+0";
      add(claim["components"][0], 1);
      return std::none_of(
          level["components"].begin(), level["components"].end(),
          [&](const Json& c) { return c["first_vertex"] == claim["components"][0]; });
    default:
      return claim["radius"] = "0x0p+0", claim["of"] = "vector", true;
  }
}

/// Radii that an array of the input has: of another hash, of a field that is isotropic within them,
/// or no radii.
bool tell_radii(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("mode") || level["components"].empty()) return false;
  const std::size_t lie = pick.below(5);
  const double number = lie == 0 ? 1e300 : lie == 1 ? -1 : 0;
  const std::vector<double> numbers(e.mesh.points.size(), number);
  std::string text =
      "<DataArray type=\"Float64\" Name=\"radius\" NumberOfComponents=\"1\" "
      "format=\"ascii\">";
  for (const double x : numbers) text += Json(x).dump() + ' ';
  e.in_field.push_back({"</PointData>", text + "</DataArray></PointData>", true});
  Json& claim =
      level["stability"] = {{"array", lie == 2   ? "stress"
                                      : lie == 3 ? "radii"
                                                 : "radius"},
                            {"sha256", numbers_sha256(numbers)},
                            {"of", "array"},
                            {"components", Json::array({level["components"][0]["first_vertex"]})}};
  if (lie == 4) claim["sha256"] = numbers_sha256(std::vector<double>(numbers.size(), 1));
  return true;
}

/// A triangle has a corner twice, nearly.
bool tell_embedded(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  const std::size_t first = level["triangles"][0], count = level["triangles"][1];
  if (count == 0) return false;
  const auto& t = e.surface.triangles[first + pick.below(count)];
  e.surface.points[static_cast<std::size_t>(t[0])] =
      e.surface.points[static_cast<std::size_t>(t[1])];
  level["embedded"] = true, level["distance"] = nullptr;
  return e.rehash(), true;
}

/// Excepted: a tetrahedron that holds no triangles, or one twice.
bool tell_excepted(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("isotopic")) return false;
  Json& except = level["isotopic"]["except"];
  if (!except.empty() && pick.coin()) return except.push_back(except.back()), true;
  return except.push_back(1000000 + pick.below(1000)), true;
}

/// Claimed of what was excepted, too: cones, rings.
bool tell_shown(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("isotopic") || level["isotopic"]["except"].empty()) return false;
  Json& except = level["isotopic"]["except"];
  if (pick.coin()) return except.clear(), true;
  return except.erase(pick.below(except.size())), true;
}

/// Two corners of a triangle inside a tetrahedron, one bit from each other: it has an area, and
/// what is between it and its neighbours is less than rounding.
bool tell_close_triangles(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("isotopic")) return false;
  const auto& except = level["isotopic"]["except"];
  const std::size_t first = level["triangles"][0], count = level["triangles"][1];
  for (std::size_t tries = 0; tries < 20 && count > 0; ++tries) {
    const std::size_t t = first + pick.below(count);
    const auto [v, w, x] = e.surface.triangles[t];
    bool is_inside = true;
    for (std::size_t s = 0; s < e.surface.triangles.size(); ++s)
      if (std::count(e.surface.triangles[s].begin(), e.surface.triangles[s].end(), v) > 0)
        is_inside = is_inside && e.surface.tet[s] == e.surface.tet[t];
    const bool is_excepted =
        std::find(except.begin(), except.end(), Json(e.surface.tet[t])) != except.end();
    if (is_excepted || !is_inside) continue;
    auto& point = e.surface.points[as_size(v)];
    point = e.surface.points[as_size(w)];
    point.x = std::nextafter(point.x, e.surface.points[as_size(x)].x);
    level["distance"] = nullptr;
    return e.rehash(), true;
  }
  return false;
}

}  // namespace

std::vector<LieRow> lies_of_optional_claims() {
  return {
      {"stability", tell_stable_component},
      {"stability: radii of an array", tell_radii},
      {"embedded", tell_embedded},
      {"isotopic", tell_excepted},
      {"isotopic: a sheet that is no disc", tell_shown},
      {"isotopic: triangles too close", tell_close_triangles},
      {"distance: bounds, coarse", tell_distance},
      {"distance: reach", tell_reaches},
  };
}

}  // namespace tensortopo::test
