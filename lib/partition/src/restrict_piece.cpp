// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/restrict_piece.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "cut_folds.hpp"
#include "owned_part.hpp"
#include "surface_fans.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Id = std::int64_t;

[[noreturn]] void refuse_part(const std::string& text) {
  throw std::invalid_argument("pieces: " + text);
}

/// What the part calls an id of the whole mesh.
class Names {
 public:
  Names(const std::vector<std::array<Id, 2>>& pairs, const char* what)
      : pairs_(pairs), what_(what) {
    std::sort(pairs_.begin(), pairs_.end());
    std::vector<Id> there;
    for (const auto& [whole, part] : pairs_) {
      if (whole < 0 || part < 0)
        refuse_part("a " + std::string(what) + " of a part has a negative id");
      there.push_back(part);
    }
    std::sort(there.begin(), there.end());
    const auto same = [](const auto& a, const auto& b) { return a[0] == b[0]; };
    if (std::adjacent_find(pairs_.begin(), pairs_.end(), same) != pairs_.end() ||
        std::adjacent_find(there.begin(), there.end()) != there.end())
      refuse_part("a " + std::string(what) + " of a part has the id of another");
  }

  bool has(Id whole) const { return find(whole) != pairs_.end(); }
  Id of(Id whole) const {
    const auto place = find(whole);
    if (place == pairs_.end())
      refuse_part(std::string(what_) + " " + std::to_string(whole) + " has no number in the part");
    return (*place)[1];
  }

 private:
  std::vector<std::array<Id, 2>>::const_iterator find(Id whole) const {
    const auto place = std::lower_bound(pairs_.begin(), pairs_.end(), std::array<Id, 2>{whole, 0});
    return place != pairs_.end() && (*place)[0] == whole ? place : pairs_.end();
  }
  std::vector<std::array<Id, 2>> pairs_;
  const char* what_;
};

/// The part's ids as runs; the piece owns what they are of.
std::vector<std::array<Id, 2>> part_ids(const PieceSurface& piece, const PartNumbers& numbers) {
  std::vector<Id> ids;
  for (const auto& [whole, part] : numbers.tets) {
    if (!owns(piece.owned_ids, whole))
      refuse_part("cell " + std::to_string(whole) + " of a part is not owned by its piece");
    ids.push_back(part);
  }
  return runs_of(std::move(ids));
}

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
void name_anew(PieceSurface& piece, const Names& tets, const Names& vertices) {
  std::vector<Id> ids;
  for (const Id id : piece.vertex_ids) ids.push_back(vertices.of(id));
  std::vector<Index> order(ids.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return ids[as_size(a)] < ids[as_size(b)]; });
  const std::vector<Index> number = inverse_permutation(order);
  TetMesh cells;
  piece.vertex_ids.clear();
  for (const Index v : order) {
    piece.vertex_ids.push_back(ids[as_size(v)]);
    cells.points.push_back(piece.cells.points[as_size(v)]);
    cells.tensors.push_back(piece.cells.tensors[as_size(v)]);
  }
  cells.tets = std::move(piece.cells.tets);
  for (auto& corners : cells.tets)
    for (Index& v : corners) v = number[as_size(v)];
  for (const Id id : piece.cells.cell_ids) cells.cell_ids.push_back(tets.of(id));
  piece.cells = std::move(cells);
  for (auto& carrier : piece.surface.carrier_vertices) {
    const auto end = std::find(carrier.begin(), carrier.end(), -1);
    for (auto v = carrier.begin(); v != end; ++v) *v = number[as_size(*v)];
    std::sort(carrier.begin(), end);
  }
  if (!piece.topology) return;
  std::vector<Index> same(piece.cells.tets.size());
  std::iota(same.begin(), same.end(), 0);
  renumber_mesh(*piece.topology, number, same);
  put_vertices_in_order(*piece.topology);
}

}  // namespace

PieceSurface restrict_piece(const PieceSurface& piece, const PartNumbers& numbers) {
  const Names tets(numbers.tets, "cell"), vertices(numbers.vertices, "vertex");
  PieceSurface result = piece;
  result.owned_ids = part_ids(piece, numbers);
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
