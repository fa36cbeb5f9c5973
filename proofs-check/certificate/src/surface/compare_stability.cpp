// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/compare_stability.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "free_tets.hpp"
#include "run/parallel.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using Face = std::array<std::uint32_t, 3>;

std::array<Face, 4> faces_of(const std::array<std::uint32_t, 4>& tet) {
  return {{{tet[1], tet[2], tet[3]},
           {tet[0], tet[2], tet[3]},
           {tet[0], tet[1], tet[3]},
           {tet[0], tet[1], tet[2]}}};
}

/// The tetrahedra that hold triangles of each component, by its smallest vertex.
std::map<Number, std::vector<std::size_t>> tets_by_component(const LevelCase& c,
                                                             const PlacedSurface& placed) {
  UnionFind vertices;
  const auto corners = [&](std::size_t i) { return c.surface.triangles[c.triangles.first + i]; };
  for (std::size_t i = 0; i < placed.tets.size(); ++i)
    for (const std::uint32_t v : corners(i)) vertices.join(corners(i)[0], v);
  std::map<Number, std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < placed.tets.size(); ++i)
    result[vertices.find(corners(i)[0])].push_back(placed.tets[i]);
  for (auto& [vertex, tets] : result) {
    std::sort(tets.begin(), tets.end());
    tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
  }
  return result;
}

}  // namespace

void compare_stability(const LevelCase& c, const std::string& input_file,
                       const PlacedSurface* placed, Ledger& ledger) {
  const Json& claims = c.claims["stability"];
  Radius radius = radius_of(claims);
  LevelReport& report = ledger.of_level();
  report.radius = radius.value, report.radius_of_deviator = radius.of_deviator;
  report.claims_stability = true;
  if (claims.contains("array")) {
    report.radius_array = claims["array"].get<std::string>();
    const Radii radii = read_radii(input_file, report.radius_array, c.input.points.size());
    if (radii.sha256() != claims["sha256"].get<std::string>())
      return ledger.refute("stability", "sha256 of radii " + claims["sha256"].dump(),
                           radii.sha256());
    radius.each = radii.numbers;
    if (!radius.each.empty())
      report.radius = *std::max_element(radius.each.begin(), radius.each.end());
  }
  if (!c.claims.contains("mode"))
    return ledger.refute("stability", "of a level of another invariant", "claimed of modes only");
  const auto name = [](const Json& vertex) { return "stable component " + vertex.dump(); };
  if (placed == nullptr) {
    for (const Json& vertex : claims["components"])
      ledger.leave_open(name(vertex), "the surface is not certified");
    return;
  }
  const mpq_class mu = mode_of(c.claims["mode"]);
  const ModeBall mode(mu.get_num(), mu.get_den());
  const auto components = tets_by_component(c, *placed);
  std::set<Face> beside;  // what is left out
  for (std::size_t t = 0; t < c.left_out.size(); ++t)
    if (c.left_out[t])
      for (const Face& face : faces_of(c.input.tets[t])) beside.insert(face);
  for (const Json& vertex : claims["components"]) {
    const auto found = components.find(vertex.get<Number>());
    if (found == components.end()) {
      std::string all;
      for (const auto& [smallest, tets] : components) all += ' ' + std::to_string(smallest);
      ledger.refute(name(vertex), "a component's smallest vertex", "these are" + all.substr(0, 200));
      continue;
    }
    const auto is_left_out = [&](std::size_t t) {
      const auto faces = faces_of(c.input.tets[t]);
      return c.left_out[t] || std::any_of(faces.begin(), faces.end(),
                                          [&](const Face& f) { return beside.contains(f); });
    };
    if (const auto left = std::find_if(found->second.begin(), found->second.end(), is_left_out);
        left != found->second.end()) {
      ledger.refute(name(vertex), "stable",
                    "tetrahedron " + std::to_string(c.input.cells[*left]) +
                        " is left out, or has a face in common with one that is");
      continue;
    }
    const Freedom freedom =
        are_free(c.input, c.field, mode, radius, found->second, in_parallel(c.progress));
    switch (freedom.answer) {
      case Answer::yes:
        report.stable_components.push_back(vertex.get<Number>());
        ledger.certify();
        break;
      case Answer::no: ledger.refute(name(vertex), "stable", freedom.place + " is not"); break;
      case Answer::unsure: ledger.leave_open(name(vertex), freedom.place + ": no proof closes");
    }
  }
}

}  // namespace certificate
