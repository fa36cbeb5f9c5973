// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "curves/line_order.hpp"
#include "curves/piece_vertices.hpp"
#include "owned_part.hpp"
#include "piece_messages.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Simplex = std::array<Index, 4>;

/// The vertices, edges and faces of a tetrahedron, ascending; -1 fills up.
std::array<Simplex, 14> simplices_below(std::array<Index, 4> tet) {
  std::sort(tet.begin(), tet.end());
  std::array<Simplex, 14> result{};
  for (unsigned set = 1; set < 15; ++set) {
    Simplex& simplex = result[set - 1];
    simplex.fill(-1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if ((set >> i & 1) != 0) simplex[count++] = tet[i];
  }
  return result;
}

/// Of simplices: which of them a ghost has.
/// @param simplices  ascending, each once
std::vector<char> those_in_ghosts(const MeshPiece& piece, const std::vector<Simplex>& simplices) {
  std::vector<char> result(simplices.size(), 0);
  if (simplices.empty()) return result;
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t) {
    if (piece.is_owned[t] != 0) continue;
    for (const Simplex& simplex : simplices_below(piece.mesh.tets[t])) {
      const auto at = std::lower_bound(simplices.begin(), simplices.end(), simplex);
      if (at != simplices.end() && *at == simplex) result[as_size(at - simplices.begin())] = 1;
    }
  }
  return result;
}

/// @param curves  whose vertices have carriers in numbers of the piece's mesh
std::vector<char> shared_vertices(const MeshPiece& piece, const PieceCurves& part) {
  const auto& carriers = part.curves.carrier_vertices;
  const auto is_end = [&](std::size_t v) {
    return part.keys.vertices[v].kind < CurveVertexKind::in_tet;
  };
  std::vector<Simplex> simplices;
  for (std::size_t v = 0; v < carriers.size(); ++v)
    if (is_end(v)) simplices.push_back(carriers[v]);
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  const auto in_ghosts = those_in_ghosts(piece, simplices);
  std::vector<char> result(carriers.size(), 0);
  for (std::size_t v = 0; v < carriers.size(); ++v)
    if (is_end(v)) {
      const auto at = std::lower_bound(simplices.begin(), simplices.end(), carriers[v]);
      result[v] = in_ghosts[as_size(at - simplices.begin())];
    }
  return result;
}

std::vector<OwnedCurveCell> owned_cells(const MeshPiece& piece,
                                        const std::vector<UnresolvedCurve>& cells) {
  std::vector<OwnedCurveCell> result;
  for (const UnresolvedCurve& cell : cells)
    if (piece.is_owned[as_size(cell.tet)] != 0)
      result.push_back({piece.mesh.cell_ids[as_size(cell.tet)], cell.obstacle});
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
  return result;
}

/// Takes out lines in ghosts, and vertices that no other line has.
void keep_owned_lines(const MeshPiece& piece, PieceCurves& part) {
  CurveMesh& curves = part.curves;
  std::vector<char> is_kept(curves.lines.size()), is_used(curves.points.size(), 0);
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    is_kept[i] = piece.is_owned[as_size(curves.tet[i])];
    if (is_kept[i] != 0)
      for (const Index v : curves.lines[i]) is_used[as_size(v)] = 1;
  }
  keep(curves.lines, is_kept);
  keep(curves.tet, is_kept);
  keep(part.keys.lines, is_kept);
  const auto number = numbers_of_kept(is_used);
  for (auto& line : curves.lines)
    for (Index& v : line) v = number[as_size(v)];
  keep(curves.points, is_used);
  keep(curves.carrier, is_used);
  keep(curves.carrier_vertices, is_used);
  keep(curves.dominant_eigenvector, is_used);
  keep(curves.mode, is_used);
  keep(curves.separation, is_used);
  keep(curves.residual, is_used);
  keep(part.keys.vertices, is_used);
  keep(part.around, is_used);
}

/// Gathers the tetrahedra with lines, and those that are unresolved or special; counts in terms of
/// these.
void gather_cells_of_lines(const MeshPiece& piece, PieceCurves& part) {
  CurveMesh& curves = part.curves;
  std::vector<std::int64_t> named;
  for (const auto* list : {&part.unresolved, &part.special})
    for (const OwnedCurveCell& cell : *list) named.push_back(cell.cell_id);
  std::sort(named.begin(), named.end());
  std::vector<char> is_crossed(piece.mesh.tets.size(), 0);
  for (std::size_t t = 0; t < is_crossed.size(); ++t)
    is_crossed[t] = std::binary_search(named.begin(), named.end(), piece.mesh.cell_ids[t]);
  for (const Index t : curves.tet) is_crossed[as_size(t)] = 1;
  const KeptCells kept = keep_cells(piece, is_crossed, part.cells, part.vertex_ids);
  const auto to_cells = [&](Simplex& simplex) {
    const auto end = std::find(simplex.begin(), simplex.end(), -1);
    for (auto v = simplex.begin(); v != end; ++v) *v = kept.vertex[as_size(*v)];
  };
  for (Index& t : curves.tet) t = kept.tet[as_size(t)];
  for (auto& carrier : curves.carrier_vertices) to_cells(carrier);
  for (auto& line : part.keys.lines) to_cells(line.cell);
}

/// In the order of the keys of first lines.
std::vector<Index> components_of_lines(const PieceCurves& part) {
  const auto& lines = part.curves.lines;
  UnionFind classes(part.curves.points.size());
  for (const auto& line : lines)
    classes.unite(static_cast<std::uint32_t>(line.front()),
                  static_cast<std::uint32_t>(line.back()));
  const auto rank = inverse_permutation(canonical_mesh(part.cells).vertices);
  std::vector<std::tuple<CellOrder, std::int32_t, std::size_t>> order;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& key = part.keys.lines[i];
    order.emplace_back(order_of_cell(key.cell, rank), key.ordinal, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> number(classes.size(), -1), result(lines.size());
  Index count = 0;
  for (const auto& [cell, ordinal, i] : order) {
    Index& known = number[classes.find(static_cast<std::uint32_t>(lines[i].front()))];
    if (known < 0) known = count++;
    result[i] = known;
  }
  return result;
}

}  // namespace

PieceCurves owned_curves(const MeshPiece& piece, Degeneracy kind, KeyedCurves made) {
  require_sound(piece);
  if (!std::is_sorted(piece.vertex_ids.begin(), piece.vertex_ids.end()))
    throw std::invalid_argument("piece: its vertices are not in the order of their ids; sort them");
  PieceCurves result;
  result.kind = kind;
  result.curves = std::move(made.extraction.curves);
  result.keys = std::move(made.keys);
  result.owned_ids = owned_ids_of(piece);
  result.whole_tets = piece.whole_tets;
  result.unresolved = owned_cells(piece, made.extraction.unresolved);
  result.special = owned_cells(piece, made.extraction.special);
  add_messages(piece, std::exchange(result.keys.messages, {}), result.told, result.heard);
  result.around = lines_around(result.curves, piece.mesh.cell_ids);
  keep_owned_lines(piece, result);
  result.is_shared = shared_vertices(piece, result);
  gather_cells_of_lines(piece, result);
  result.curves.component = components_of_lines(result);
  return result;
}

PieceCurves extract_curve_piece(const MeshPiece& given, Degeneracy kind,
                                const ExtractOptions& options) {
  require_sound(given);
  const MeshPiece piece = in_order_of_ids(given);
  return owned_curves(piece, kind, extract_keyed_curves(piece.mesh, kind, options));
}

}  // namespace tensortopo
