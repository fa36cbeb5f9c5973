// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "crossing_brackets.hpp"
#include "distance_proof.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

std::size_t as_size(Index i) { return static_cast<std::size_t>(i); }

using Brackets = std::vector<std::optional<std::vector<DyadicBracket>>>;

Brackets brackets_of(const LevelTopology& topology, const ScaledField<double>& field,
                     const Level<double>& level) {
  Brackets brackets(topology.edges.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, brackets.size(), 256),
                    [&](const auto& range) {
                      const FloatingPointEnvironment environment;
                      for (std::size_t e = range.begin(); e != range.end(); ++e)
                        brackets[e] = crossing_brackets(topology.edges[e], field, level);
                    });
  return brackets;
}

/// Leaves the entries for which `keep` is true.
template <class T, class Keep>
void retain(std::vector<T>& list, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (keep(i)) {
      if (kept != i) list[kept] = std::move(list[i]);
      ++kept;
    }
  list.resize(kept);
}

/// Tetrahedra with one of the edges that have no brackets are undecided, and what only they hold is
/// not claimed.
void drop_unbracketed(const TetMesh& mesh, LevelTopology& topology, Brackets& brackets,
                      std::vector<UndecidedCell>& undecided) {
  std::set<std::array<Index, 2>> bad;
  for (std::size_t e = 0; e < brackets.size(); ++e)
    if (!brackets[e]) bad.insert(topology.edges[e].vertices);
  if (bad.empty()) return;
  std::set<std::array<Index, 2>> edges;
  std::set<std::array<Index, 3>> faces;
  const auto has_brackets = [&](Index tet) {
    auto v = mesh.tets[as_size(tet)];
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (bad.contains({v[i], v[j]})) {
          undecided.push_back({tet, "budget_exhausted"});
          return false;
        }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) edges.insert({v[i], v[j]});
      faces.insert({v[i == 0 ? 1 : 0], v[i < 2 ? 2 : 1], v[i < 3 ? 3 : 2]});
    }
    return true;
  };
  retain(topology.tets, [&](std::size_t t) { return has_brackets(topology.tets[t].tet); });
  retain(topology.cones, [&](std::size_t t) { return has_brackets(topology.cones[t].tet); });
  const auto has_edge = [&](std::size_t e) { return edges.contains(topology.edges[e].vertices); };
  retain(brackets, has_edge);
  retain(topology.edges, has_edge);
  retain(topology.faces,
         [&](std::size_t f) { return faces.contains(topology.faces[f].vertices); });
}

std::vector<ComponentClaim> components_of(const SurfaceMesh& surface) {
  const auto known = surface_invariants(surface);
  std::vector<ComponentClaim> claims(known.parts.size());
  for (std::size_t c = 0; c < claims.size(); ++c) {
    claims[c].euler_characteristic = known.parts[c].euler_characteristic;
    claims[c].boundary_loops = static_cast<std::size_t>(known.parts[c].boundary_loops);
    claims[c].orientable = known.parts[c].orientable;
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    auto& claim = claims[as_size(known.component[i])];
    ++claim.triangles;
    for (const auto v : surface.triangles[i])
      if (claim.first_vertex < 0 || v < claim.first_vertex) claim.first_vertex = v;
  }
  std::sort(claims.begin(), claims.end(), [](const auto& p, const auto& q) {
    return p.first_vertex < q.first_vertex;
  });
  return claims;
}

}  // namespace

CertifiedLevel certify(const TetMesh& mesh, const ModeValue& mode, Extraction& extraction) {
  const SurfaceMesh& surface = extraction.surface;
  const ScaledField<double> field(mesh);
  const auto level = make_level<double>(mode);
  CertifiedLevel result;
  result.mode = mode;
  result.vertices = surface.points.size();
  result.triangles = surface.triangles.size();
  result.on_level = extraction.statistics.vertices_on_level;
  result.topology = std::move(extraction.topology);

  for (const auto& cell : extraction.unresolved)
    result.undecided.push_back({cell.tet, std::string(name_of(cell.reason))});
  auto brackets = brackets_of(result.topology, field, level);
  drop_unbracketed(mesh, result.topology, brackets, result.undecided);
  for (auto& list : brackets) result.brackets.push_back(std::move(*list));
  std::sort(result.undecided.begin(), result.undecided.end(),
            [](const auto& p, const auto& q) { return p.tet < q.tet; });

  std::vector<char> is_undecided(mesh.tets.size(), 0);
  for (const auto& cell : result.undecided) is_undecided[as_size(cell.tet)] = 1;
  std::vector<std::size_t> triangles;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    if (!is_undecided[as_size(surface.tet[i])]) triangles.push_back(i);
  result.components = components_of(surface);
  result.distance = prove_distance(mesh, surface, triangles, result.topology, field, level);
  return result;
}

}  // namespace tensortopo
