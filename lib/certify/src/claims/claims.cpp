// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/claims.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

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

std::array<Index, 4> sorted_vertices(const TetMesh& mesh, Index tet) {
  auto v = mesh.tets[as_size(tet)];
  std::sort(v.begin(), v.end());
  return v;
}

}  // namespace

void drop_cells(const TetMesh& mesh, CertifiedLevel& level, Brackets brackets,
                const std::function<std::string(Index)>& reason) {
  LevelTopology& topology = level.topology;
  std::set<std::array<Index, 2>> unbracketed;
  for (std::size_t e = 0; e < brackets.size(); ++e)
    if (!brackets[e]) unbracketed.insert(topology.edges[e].vertices);
  const auto is_unbracketed = [&](Index tet) {
    const auto v = sorted_vertices(mesh, tet);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (unbracketed.contains({v[i], v[j]})) return true;
    return false;
  };
  const std::size_t before = level.undecided.size();
  const auto stays = [&](Index tet) {
    std::string why = reason(tet);
    if (why.empty() && !unbracketed.empty() && is_unbracketed(tet)) why = "budget_exhausted";
    if (!why.empty()) level.undecided.push_back({tet, why});
    return why.empty();
  };
  retain(topology.tets, [&](std::size_t t) { return stays(topology.tets[t].tet); });
  retain(topology.cones, [&](std::size_t t) { return stays(topology.cones[t].tet); });
  if (level.undecided.size() > before || !unbracketed.empty()) {
    std::set<std::array<Index, 2>> edges;
    std::set<std::array<Index, 3>> faces;
    const auto note = [&](Index tet) {
      const auto v = sorted_vertices(mesh, tet);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) edges.insert({v[i], v[j]});
        faces.insert({v[i == 0 ? 1 : 0], v[i < 2 ? 2 : 1], v[i < 3 ? 3 : 2]});
      }
    };
    for (const auto& tet : topology.tets) note(tet.tet);
    for (const auto& cone : topology.cones) note(cone.tet);
    const auto has_edge = [&](std::size_t e) { return edges.contains(topology.edges[e].vertices); };
    retain(brackets, has_edge);
    retain(topology.edges, has_edge);
    retain(topology.faces,
           [&](std::size_t f) { return faces.contains(topology.faces[f].vertices); });
  }
  for (auto& list : brackets) level.brackets.push_back(std::move(*list));
  std::sort(level.undecided.begin(), level.undecided.end(),
            [](const auto& p, const auto& q) { return p.tet < q.tet; });
}

std::vector<TetMesh::Index> tets_of(const std::vector<UndecidedCell>& cells) {
  std::vector<TetMesh::Index> tets;
  for (const auto& cell : cells) tets.push_back(cell.tet);
  return tets;
}

std::vector<std::size_t> decided_triangles(const TetMesh& mesh, const SurfaceMesh& surface,
                                           const CertifiedLevel& level) {
  std::vector<char> is_undecided(mesh.tets.size(), 0);
  for (const auto& cell : level.undecided) is_undecided[as_size(cell.tet)] = 1;
  std::vector<std::size_t> triangles;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    if (!is_undecided[as_size(surface.tet[i])]) triangles.push_back(i);
  return triangles;
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
  std::sort(claims.begin(), claims.end(),
            [](const auto& p, const auto& q) { return p.first_vertex < q.first_vertex; });
  return claims;
}

}  // namespace tensortopo
