// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/compare_stability.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "free_tets.hpp"
#include "run/parallel.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using FaceOfTet = std::array<std::uint32_t, 3>;

std::array<FaceOfTet, 4> faces_of(const std::array<std::uint32_t, 4>& tet) {
  return {{{tet[1], tet[2], tet[3]},
           {tet[0], tet[2], tet[3]},
           {tet[0], tet[1], tet[3]},
           {tet[0], tet[1], tet[2]}}};
}

using Components = std::map<Number, std::vector<std::size_t>>;

/// The tetrahedra that hold the cells of each component, by its smallest vertex.
/// @param vertices_of  of a cell, by its number
template <class VerticesOf>
Components tets_by_component(const std::vector<std::size_t>& tets, const VerticesOf& vertices_of) {
  UnionFind vertices;
  for (std::size_t i = 0; i < tets.size(); ++i)
    for (const std::uint32_t v : vertices_of(i)) vertices.join(vertices_of(i)[0], v);
  Components result;
  for (std::size_t i = 0; i < tets.size(); ++i)
    result[vertices.find(vertices_of(i)[0])].push_back(tets[i]);
  for (auto& [vertex, of_one] : result) {
    std::sort(of_one.begin(), of_one.end());
    of_one.erase(std::unique(of_one.begin(), of_one.end()), of_one.end());
  }
  return result;
}

/// The radii that a claim is about, in the report too; nothing if they are not the input's.
std::optional<Radius> given_radius(const Json& claims, const RadiiByArray& by_array,
                                   Ledger& ledger) {
  Radius radius = radius_of(claims);
  LevelReport& report = ledger.of_level();
  report.radius = radius.value, report.radius_of_deviator = radius.of_deviator;
  report.claims_stability = true;
  if (!claims.contains("array")) return radius;
  report.radius_array = claims["array"].get<std::string>();
  const Radii& radii = by_array.at(report.radius_array);
  if (radii.sha256() != claims["sha256"].get<std::string>()) {
    ledger.refute("stability", "sha256 of radii " + claims["sha256"].dump(), radii.sha256());
    return std::nullopt;
  }
  radius.each = radii.numbers;
  if (!radius.each.empty())
    report.radius = *std::max_element(radius.each.begin(), radius.each.end());
  return radius;
}

std::string name_of(const Json& vertex) { return "stable component " + vertex.dump(); }

constexpr const char* kCrossings = "stable crossings";

void leave_all_open(const Json& claims, const char* why, Ledger& ledger) {
  for (const Json& vertex : claims["components"]) ledger.leave_open(name_of(vertex), why);
  if (claims.contains("crossings")) ledger.leave_open(kCrossings, why);
}

/// @param simplices  the level's, with what is derived of them: N vertices come first
/// @param question  are some of them crossed alike by all members?
template <std::size_t N, class Question>
void compare_crossings(const Json& claims, const Json& simplices, const Question& question,
                       Ledger& ledger) {
  if (!claims.contains("crossings")) return;
  std::vector<std::array<std::uint32_t, N>> named;
  for (const Json& place : claims["crossings"]) {
    if (place.get<Number>() >= simplices.size())
      return ledger.refute(kCrossings, place.dump(),
                           std::to_string(simplices.size()) + " are listed");
    auto& vertices = named.emplace_back();
    for (std::size_t i = 0; i < N; ++i)
      vertices[i] = static_cast<std::uint32_t>(simplices[place.get<Number>()][i].get<Number>());
  }
  const Freedom freedom = question(named);
  switch (freedom.answer) {
    case Answer::yes:
      ledger.of_level().stable_crossings = named.size();
      ledger.certify();
      break;
    case Answer::no: ledger.refute(kCrossings, "stable", freedom.place + " is not"); break;
    case Answer::unsure: ledger.leave_open(kCrossings, freedom.place + ": no proof closes");
  }
}

/// @param question  are some tetrahedra the same for all members?
template <class Question>
void compare_components(const Json& claims, const Input& input, const std::vector<bool>& left_out,
                        const Components& components, const Question& question, Ledger& ledger) {
  std::set<FaceOfTet> beside;  // what is left out
  for (std::size_t t = 0; t < left_out.size(); ++t)
    if (left_out[t])
      for (const FaceOfTet& face : faces_of(input.tets[t])) beside.insert(face);
  for (const Json& vertex : claims["components"]) {
    const std::string name = name_of(vertex);
    const auto found = components.find(vertex.get<Number>());
    if (found == components.end()) {
      std::string all;
      for (const auto& [smallest, tets] : components) all += ' ' + std::to_string(smallest);
      ledger.refute(name, "a component's smallest vertex", "these are" + all.substr(0, 200));
      continue;
    }
    const auto is_left_out = [&](std::size_t t) {
      const auto faces = faces_of(input.tets[t]);
      return left_out[t] || std::any_of(faces.begin(), faces.end(),
                                        [&](const FaceOfTet& f) { return beside.contains(f); });
    };
    if (const auto left = std::find_if(found->second.begin(), found->second.end(), is_left_out);
        left != found->second.end()) {
      ledger.refute(name, "stable",
                    "tetrahedron " + std::to_string(input.cells[*left]) +
                        " is left out, or has a face in common with one that is");
      continue;
    }
    const Freedom freedom = question(found->second);
    switch (freedom.answer) {
      case Answer::yes:
        ledger.of_level().stable_components.push_back(vertex.get<Number>());
        ledger.certify();
        break;
      case Answer::no: ledger.refute(name, "stable", freedom.place + " is not"); break;
      case Answer::unsure: ledger.leave_open(name, freedom.place + ": no proof closes");
    }
  }
}

}  // namespace

void compare_stability(const LevelCase& c, const RadiiByArray& radii, const PlacedSurface* placed,
                       Ledger& ledger) {
  const Json& claims = c.claims["stability"];
  const auto radius = given_radius(claims, radii, ledger);
  if (!radius) return;
  if (!c.claims.contains("mode"))
    return ledger.refute("stability", "of a level of another invariant", "claimed of modes only");
  if (placed == nullptr) return leave_all_open(claims, "the surface is not certified", ledger);
  const mpq_class mu = mode_of(c.claims["mode"]);
  const ModeBall mode(mu.get_num(), mu.get_den());
  const auto components = tets_by_component(
      placed->tets, [&](std::size_t i) { return c.surface.triangles[c.triangles.first + i]; });
  compare_components(claims, c.input, c.left_out, components,
                     [&](const std::vector<std::size_t>& tets) {
                       return are_free(c.input, c.field, mode, *radius, tets,
                                       in_parallel(c.progress));
                     },
                     ledger);
  compare_crossings<2>(claims, c.claims["edges"],
                       [&](const std::vector<std::array<std::uint32_t, 2>>& edges) {
                         return are_free(c.field, mode, *radius, edges, in_parallel(c.progress));
                       },
                       ledger);
}

void compare_stability(const CurveCase& c, const RadiiByArray& radii, bool is_sound,
                       const Progress& progress, Ledger& ledger) {
  const Json& claims = c.claims["stability"];
  const auto radius = given_radius(claims, radii, ledger);
  if (!radius) return;
  if (!is_sound) return leave_all_open(claims, "the curves are not certified", ledger);
  std::vector<std::size_t> tets;
  for (Number l = 0; l < c.lines.count; ++l)
    tets.push_back(c.input.tet_at(c.curves.cells[c.lines.first + l]));
  const auto components = tets_by_component(
      tets, [&](std::size_t i) { return std::span(c.curves.lines[c.lines.first + i]); });
  const bool is_planar = kind_of(c.claims["mode"]) == Kind::planar;
  compare_components(claims, c.input, c.left_out, components,
                     [&](const std::vector<std::size_t>& of_one) {
                       return are_transverse(c.input, c.field, is_planar, *radius, of_one,
                                             in_parallel(progress));
                     },
                     ledger);
  compare_crossings<3>(claims, c.claims["faces"],
                       [&](const std::vector<std::array<std::uint32_t, 3>>& faces) {
                         return are_transverse(c.field, is_planar, *radius, faces,
                                               in_parallel(progress));
                       },
                       ledger);
}

}  // namespace certificate
