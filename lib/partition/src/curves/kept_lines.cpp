// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curves/kept_lines.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

#include "curves/line_order.hpp"
#include "owned_part.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

using Index = TetMesh::Index;

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
  if (!part.is_shared.empty()) keep(part.is_shared, is_used);
}

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
  const auto to_cells = [&](std::array<Index, 4>& simplex) {
    const auto end = std::find(simplex.begin(), simplex.end(), -1);
    for (auto v = simplex.begin(); v != end; ++v) *v = kept.vertex[as_size(*v)];
  };
  for (Index& t : curves.tet) t = kept.tet[as_size(t)];
  for (auto& carrier : curves.carrier_vertices) to_cells(carrier);
  for (auto& line : part.keys.lines) to_cells(line.cell);
}

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

}  // namespace tensortopo
