// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "whole_curves.hpp"

#include <utility>

#include "mode_parts.hpp"
#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/seam_numbers.hpp"

namespace tensortopo::filters {

namespace {

using Index = CurveMesh::Index;
using Numbers = std::vector<std::int64_t>;

/// What a piece's curves need of a kind's part.
CurveMesh curves_of_part(const CurveMesh& all, const ModePart& part, std::size_t first_vertex,
                         std::size_t first_line) {
  const auto vertices = [&](const auto& values) {
    return some(values, first_vertex, part.vertices);
  };
  CurveMesh curves;
  curves.points = vertices(all.points);
  curves.carrier = vertices(all.carrier);
  curves.carrier_vertices = vertices(all.carrier_vertices);
  curves.dominant_eigenvector = vertices(all.dominant_eigenvector);
  curves.mode = vertices(all.mode);
  curves.separation = vertices(all.separation);
  curves.residual = vertices(all.residual);
  curves.lines = some(all.lines, first_line, part.cells);
  for (auto& line : curves.lines)
    for (Index& v : line) v -= static_cast<Index>(first_vertex);
  curves.tet = some(all.tet, first_line, part.cells);
  return curves;
}

/// Writes the seams of a rank.
std::vector<OwnCells> write_curve_seams(const DegenerateCurves& made, const MeshPiece& piece,
                                        Numbers& to) {
  std::vector<OwnCells> own;
  std::size_t first_vertex = 0, first_line = 0;
  for (std::size_t m = 0; m < made.parts.size(); ++m) {
    const ModePart& part = made.parts[m];
    KeyedCurves keyed;
    keyed.extraction.curves = curves_of_part(made.curves, part, first_vertex, first_line);
    keyed.keys = made.keys[m];
    const Degeneracy kind = part.mode.approx() > 0 ? Degeneracy::linear : Degeneracy::planar;
    PieceCurves curves = owned_curves(piece, kind, std::move(keyed));
    CurveSeam seam = curve_seam_of(curves);
    seam.owned_ids.clear();  // all ranks know them
    write_part(part.mode, numbers_of(seam), to);
    own.push_back({own_cells(piece, made.curves.tet, first_line, part.cells),
                   std::move(curves.curves.component)});
    first_vertex += part.vertices, first_line += part.cells;
  }
  return own;
}

}  // namespace

std::vector<WholeCurves> counted(const DegenerateCurves& made) {
  std::vector<WholeCurves> counts;
  for (const ModePart& part : made.parts)
    counts.push_back({part.mode.approx(),
                      static_cast<std::int64_t>(part.curve_invariants.components),
                      static_cast<std::int64_t>(part.curve_invariants.closed_components),
                      static_cast<std::int64_t>(part.vertices),
                      static_cast<std::int64_t>(part.cells)});
  return counts;
}

std::vector<WholeCurves> number_components(DegenerateCurves& made, const TensorGrid& grid,
                                           const Ranks& ranks, const WholeMesh& whole) {
  const auto write = [&](Numbers& to) { return write_curve_seams(made, grid.piece, to); };
  const auto join = [](std::vector<CurveSeam> seams, double mode) {
    // A rank without cells has curves of any kind: none.
    for (CurveSeam& seam : seams) seam.kind = mode > 0 ? Degeneracy::linear : Degeneracy::planar;
    return join_curve_seams(seams);
  };
  std::vector<WholeCurves> counts;
  for (const auto& part : join_parts<CurveSeam>(ranks, whole, write, curve_seam_of_numbers, join,
                                                made.curves.component)) {
    const auto total = part.joined.total();
    counts.push_back({part.mode, static_cast<std::int64_t>(part.joined.components.size()),
                      part.joined.closed_components(), total.vertices, total.lines});
  }
  return counts;
}

}  // namespace tensortopo::filters
