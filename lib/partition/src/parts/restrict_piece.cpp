// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/restrict_piece.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "curves/line_order.hpp"
#include "cut_folds.hpp"
#include "owned_part.hpp"
#include "parts/part_names.hpp"
#include "surface_fans.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Id = std::int64_t;

/// Edges and faces name their vertices in ascending order, after these got numbers in another one.
void put_vertices_in_order(LevelTopology& topology) {
  for (auto& edge : topology.edges) {
    if (edge.vertices[0] < edge.vertices[1]) continue;
    std::swap(edge.vertices[0], edge.vertices[1]);
    std::reverse(edge.crossings.begin(), edge.crossings.end());
    for (auto& crossing : edge.crossings) {
      std::swap(crossing.weights[0], crossing.weights[1]);
      crossing.rising = !crossing.rising;
    }
  }
  for (auto& face : topology.faces) std::sort(face.vertices.begin(), face.vertices.end());
  const auto by_vertices = [](const auto& a, const auto& b) { return a.vertices < b.vertices; };
  std::sort(topology.edges.begin(), topology.edges.end(), by_vertices);
  std::sort(topology.faces.begin(), topology.faces.end(), by_vertices);
}

/// Gives vertices and tetrahedra the part's ids, and the vertices numbers in the order of these.
void name_anew(PieceSurface& piece, const PartNames& tets, const PartNames& vertices) {
  const std::vector<Index> number = name_cells_anew(piece.cells, piece.vertex_ids, tets, vertices);
  for (auto& carrier : piece.surface.carrier_vertices) carrier = ranks_of(carrier, number);
  if (!piece.topology) return;
  std::vector<Index> same(piece.cells.tets.size());
  std::iota(same.begin(), same.end(), 0);
  renumber_mesh(*piece.topology, number, same);
  put_vertices_in_order(*piece.topology);
}

}  // namespace

PieceSurface restrict_piece(const PieceSurface& piece, const PartNumbers& numbers) {
  const PartNames tets(numbers.tets, "cell"), vertices(numbers.vertices, "vertex");
  PieceSurface result = piece;
  result.owned_ids = part_ids(piece.owned_ids, numbers);
  std::vector<Id> isotropic;
  for (const auto& [whole, part] : numbers.tets)
    if (owns(piece.isotropic_ids, whole)) isotropic.push_back(part);
  result.isotropic_ids = runs_of(std::move(isotropic));
  result.whole_tets = static_cast<Id>(numbers.tets.size());
  result.told.clear(), result.heard.clear();
  std::erase_if(result.unresolved, [&](const auto& cell) { return !tets.has(cell.cell_id); });
  std::erase_if(result.not_embedded, [&](Id id) { return !tets.has(id); });
  std::erase_if(result.on_level, [&](Id id) { return !vertices.has(id); });

  MeshPiece cells{piece.cells, piece.vertex_ids, {}, result.whole_tets};
  for (const Id id : piece.cells.cell_ids) cells.is_owned.push_back(tets.has(id));
  if (result.topology) result.topology = topology_of_owned(std::move(*result.topology), cells);
  join_copies(result);
  keep_owned(cells, result);
  separate_copies(result, cut_folds(result, cells.is_owned));
  result.ghost_across.assign(result.surface.triangles.size(), {-1, -1, -1});
  gather_cells(cells, result);

  name_anew(result, tets, vertices);
  for (auto& cell : result.unresolved) cell.cell_id = tets.of(cell.cell_id);
  for (Id& id : result.not_embedded) id = tets.of(id);
  for (Id& id : result.on_level) id = vertices.of(id);
  std::sort(result.unresolved.begin(), result.unresolved.end(),
            [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
  std::sort(result.not_embedded.begin(), result.not_embedded.end());
  std::sort(result.on_level.begin(), result.on_level.end());
  return result;
}

}  // namespace tensortopo
