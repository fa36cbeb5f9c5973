// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "whole_surface.hpp"

#include <utility>

#include "mode_parts.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/partition/seam_numbers.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo::filters {

namespace {

using Index = SurfaceMesh::Index;
using Numbers = std::vector<std::int64_t>;

/// What a piece's surface needs of a mode's part.
SurfaceMesh part_of(const SurfaceMesh& all, const ModePart& part, std::size_t first_vertex,
                    std::size_t first_triangle) {
  const auto vertices = [&](const auto& values) {
    return some(values, first_vertex, part.vertices);
  };
  SurfaceMesh surface;
  surface.points = vertices(all.points);
  surface.carrier = vertices(all.carrier);
  surface.carrier_vertices = vertices(all.carrier_vertices);
  surface.medium_eigenvector = vertices(all.medium_eigenvector);
  surface.dominant_eigenvector = vertices(all.dominant_eigenvector);
  surface.normal = vertices(all.normal);
  surface.mode = vertices(all.mode);
  surface.residual = vertices(all.residual);
  surface.triangles = some(all.triangles, first_triangle, part.cells);
  for (auto& triangle : surface.triangles)
    for (Index& v : triangle) v -= static_cast<Index>(first_vertex);
  surface.tet = some(all.tet, first_triangle, part.cells);
  return surface;
}

/// Writes the seams of a rank.
std::vector<OwnCells> write_parts(const ModeSurfaces& made, const MeshPiece& piece, Numbers& to) {
  std::vector<OwnCells> own;
  std::size_t first_vertex = 0, first_triangle = 0;
  for (const ModePart& part : made.parts) {
    const PieceSurface surface =
        owned_surface(piece, part_of(made.surface, part, first_vertex, first_triangle));
    SurfaceSeam seam = seam_of(surface);
    seam.owned_ids.clear();  // all ranks know them
    for (const LeftOut& cell : made.unresolved)
      if (cell.mode == part.mode && piece.is_owned[as_size(cell.tet)] != 0)
        seam.unresolved.push_back(piece.mesh.cell_ids[as_size(cell.tet)]);
    write_part(part.mode, numbers_of(seam), to);
    own.push_back({own_cells(piece, made.surface.tet, first_triangle, part.cells),
                   surface_components(surface.surface)});
    first_vertex += part.vertices, first_triangle += part.cells;
  }
  return own;
}

}  // namespace

std::vector<WholeSurface> counted(const ModeSurfaces& made) {
  std::vector<WholeSurface> counts;
  for (const ModePart& part : made.parts)
    counts.push_back({part.mode.approx(), static_cast<std::int64_t>(part.invariants.components),
                      part.invariants.euler_characteristic, part.invariants.boundary_loops,
                      static_cast<std::int64_t>(part.vertices),
                      static_cast<std::int64_t>(part.cells)});
  return counts;
}

std::vector<WholeSurface> number_components(ModeSurfaces& made, const TensorGrid& grid,
                                            const Ranks& ranks, const WholeMesh& whole) {
  const auto write = [&](Numbers& to) { return write_parts(made, grid.piece, to); };
  const auto join = [](const std::vector<SurfaceSeam>& seams, double) { return join_seams(seams); };
  std::vector<WholeSurface> counts;
  for (const auto& part : join_parts<SurfaceSeam>(ranks, whole, write, seam_of_numbers, join,
                                                  made.surface.component)) {
    const auto total = part.joined.total();
    counts.push_back({part.mode, static_cast<std::int64_t>(part.joined.components.size()),
                      total.euler_characteristic, total.boundary_loops, total.vertices,
                      total.triangles});
  }
  return counts;
}

}  // namespace tensortopo::filters
