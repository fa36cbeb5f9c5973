// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "owned_part.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <vector>

#include "isotropic_tets.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

bool has_two_isotropic(const TetMesh& mesh, std::size_t tet) {
  const auto& corners = mesh.tets[tet];
  return std::count_if(corners.begin(), corners.end(),
                       [&](Index v) { return is_isotropic(mesh.tensors[as_size(v)]); }) == 2;
}

}  // namespace

std::vector<std::array<std::int64_t, 2>> runs_of(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  std::vector<std::array<std::int64_t, 2>> runs;
  for (const std::int64_t id : ids) {
    if (!runs.empty() && runs.back()[1] + 1 == id)
      runs.back()[1] = id;
    else
      runs.push_back({id, id});
  }
  return runs;
}

MeshPiece in_order_of_ids(const MeshPiece& piece) {
  std::vector<Index> order(piece.vertex_ids.size()), number(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index u, Index v) {
    return piece.vertex_ids[as_size(u)] < piece.vertex_ids[as_size(v)];
  });
  MeshPiece result;
  result.is_owned = piece.is_owned;
  result.whole_tets = piece.whole_tets;
  result.mesh.cell_ids = piece.mesh.cell_ids;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto v = as_size(order[i]);
    number[v] = static_cast<Index>(i);
    result.vertex_ids.push_back(piece.vertex_ids[v]);
    result.mesh.points.push_back(piece.mesh.points[v]);
    result.mesh.tensors.push_back(piece.mesh.tensors[v]);
  }
  result.mesh.tets = piece.mesh.tets;
  for (auto& tet : result.mesh.tets)
    for (Index& v : tet) v = number[as_size(v)];
  return result;
}

std::vector<Index> numbers_of_kept(const std::vector<char>& is_kept) {
  std::vector<Index> number(is_kept.size(), -1);
  Index next = 0;
  for (std::size_t i = 0; i < is_kept.size(); ++i)
    if (is_kept[i]) number[i] = next++;
  return number;
}

KeptCells keep_cells(const MeshPiece& piece, const std::vector<char>& is_kept, TetMesh& cells,
                     std::vector<std::int64_t>& vertex_ids) {
  std::vector<char> is_near(piece.mesh.points.size(), 0);
  for (std::size_t t = 0; t < is_kept.size(); ++t)
    if (is_kept[t])
      for (const Index v : piece.mesh.tets[t]) is_near[as_size(v)] = 1;
  KeptCells kept{numbers_of_kept(is_kept), numbers_of_kept(is_near)};
  cells = piece.mesh;
  vertex_ids = piece.vertex_ids;
  keep(cells.points, is_near);
  keep(cells.tensors, is_near);
  keep(vertex_ids, is_near);
  keep(cells.tets, is_kept);
  keep(cells.cell_ids, is_kept);
  for (auto& corners : cells.tets)
    for (Index& v : corners) v = kept.vertex[as_size(v)];
  return kept;
}

bool owns(std::span<const std::array<std::int64_t, 2>> owned_ids, std::int64_t id) {
  const auto after = std::upper_bound(owned_ids.begin(), owned_ids.end(), id,
                                      [](std::int64_t i, const auto& run) { return i < run[0]; });
  return after != owned_ids.begin() && (*(after - 1))[1] >= id;
}

void keep_owned(const MeshPiece& piece, PieceSurface& result) {
  SurfaceMesh& surface = result.surface;
  std::vector<char> is_kept(surface.triangles.size()), is_used(surface.points.size(), 0);
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    is_kept[i] = piece.is_owned[as_size(surface.tet[i])];
    if (is_kept[i])
      for (const Index v : surface.triangles[i]) is_used[as_size(v)] = 1;
  }
  if (result.topology)
    for_each_surface_vertex(*result.topology, [&](Index v) { is_used[as_size(v)] = 1; });
  keep(surface.triangles, is_kept);
  keep(surface.tet, is_kept);
  const auto number = numbers_of_kept(is_used);
  for (auto& triangle : surface.triangles)
    for (Index& v : triangle) v = number[as_size(v)];
  if (result.topology)
    for_each_surface_vertex(*result.topology, [&](Index& v) { v = number[as_size(v)]; });
  keep(surface.points, is_used);
  keep(surface.carrier, is_used);
  keep(surface.carrier_vertices, is_used);
  keep(surface.medium_eigenvector, is_used);
  keep(surface.dominant_eigenvector, is_used);
  keep(surface.normal, is_used);
  keep(surface.mode, is_used);
  keep(surface.residual, is_used);
  keep(result.ordinals, is_used);
  surface.carrier_id.clear();
  surface.component.clear();
}

void gather_cells(const MeshPiece& piece, PieceSurface& result) {
  SurfaceMesh& surface = result.surface;
  std::vector<char> is_crossed(piece.mesh.tets.size(), 0);
  for (const Index t : surface.tet) is_crossed[as_size(t)] = 1;
  std::unordered_set<std::int64_t> unresolved;
  for (const UnresolvedOwnedCell& cell : result.unresolved) unresolved.insert(cell.cell_id);
  for (std::size_t t = 0; t < is_crossed.size(); ++t)
    if (unresolved.contains(piece.mesh.cell_ids[t]) ||
        (piece.is_owned[t] && has_two_isotropic(piece.mesh, t)))
      is_crossed[t] = 1;
  const auto [tet, vertex] = keep_cells(piece, is_crossed, result.cells, result.vertex_ids);
  for (Index& t : surface.tet) t = tet[as_size(t)];
  for (auto& carrier : surface.carrier_vertices)
    for (Index& v : carrier)
      if (v >= 0) v = vertex[as_size(v)];
  if (result.topology) renumber_mesh(*result.topology, vertex, tet);
}

}  // namespace tensortopo
