// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/curve_seam.hpp"

#include <algorithm>
#include <tuple>

#include "curves/line_order.hpp"
#include "curves/piece_vertices.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Of each component the line that comes first.
std::vector<std::size_t> first_lines(const PieceCurves& piece) {
  const auto rank = inverse_permutation(canonical_mesh(piece.cells).vertices);
  using Place = std::tuple<Index, CellOrder, std::int32_t, std::size_t>;
  std::vector<Place> order;
  for (std::size_t i = 0; i < piece.curves.lines.size(); ++i) {
    const auto& key = piece.keys.lines[i];
    order.emplace_back(piece.curves.component[i], order_of_cell(key.cell, rank), key.ordinal, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> first;
  for (const auto& [component, cell, ordinal, line] : order)
    if (as_size(component) == first.size()) first.push_back(line);
  return first;
}

/// The points of the cells of first lines.
void add_first_cells(const PieceCurves& piece, CurveSeam& seam) {
  const auto first = first_lines(piece);
  std::vector<Index> number(piece.vertex_ids.size(), -1);
  for (const std::size_t line : first)
    for (const Index v : piece.keys.lines[line].cell)
      if (v >= 0) number[as_size(v)] = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<Index>(seam.vertex_ids.size());
    seam.vertex_ids.push_back(piece.vertex_ids[v]);
    seam.cells.points.push_back(piece.cells.points[v]);
    seam.cells.tensors.push_back(piece.cells.tensors[v]);
  }
  for (std::size_t c = 0; c < first.size(); ++c) {
    auto& cell = seam.components[c].first_cell;
    cell = piece.keys.lines[first[c]].cell;
    for (Index& v : cell)
      if (v >= 0) v = number[as_size(v)];
  }
}

}  // namespace

CurveSeam curve_seam_of(const PieceCurves& piece) {
  const CurveMesh& curves = piece.curves;
  CurveSeam seam;
  seam.kind = piece.kind;
  seam.owned_ids = piece.owned_ids, seam.whole_tets = piece.whole_tets;
  seam.told = piece.told, seam.heard = piece.heard;
  std::vector<Index> component(curves.points.size(), -1);
  std::vector<std::int32_t> line_ends(curves.points.size(), 0);
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const Index own = curves.component[i];
    if (as_size(own) >= seam.components.size()) seam.components.resize(as_size(own) + 1);
    ++seam.components[as_size(own)].lines;
    for (const Index v : curves.lines[i]) component[as_size(v)] = own;
    ++line_ends[as_size(curves.lines[i].front())], ++line_ends[as_size(curves.lines[i].back())];
  }
  const auto owned = lines_around(curves, piece.cells.cell_ids);
  for (std::size_t v = 0; v < curves.points.size(); ++v) {
    auto& own = seam.components[as_size(component[v])];
    ++own.vertices;
    if (piece.is_shared[v] == 0) {
      own.ends += line_ends[v] == 1, own.junctions += line_ends[v] > 2;
      continue;
    }
    auto& vertex = seam.vertices.emplace_back();
    const auto& carrier = curves.carrier_vertices[v];
    const auto last = std::transform(carrier.begin(), std::find(carrier.begin(), carrier.end(), -1),
                                     vertex.carrier_ids.begin(),
                                     [&](Index c) { return piece.vertex_ids[as_size(c)]; });
    std::sort(vertex.carrier_ids.begin(), last);
    vertex.ordinal = piece.keys.vertices[v].ordinal;
    vertex.component = component[v];
    vertex.line_ends = line_ends[v];
    vertex.owned = owned[v], vertex.around = piece.around[v];
    vertex.digest = digest_of_vertex(piece, v);
  }
  add_first_cells(piece, seam);
  return seam;
}

}  // namespace tensortopo
