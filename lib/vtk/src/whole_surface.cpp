// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "whole_surface.hpp"

#include <algorithm>
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
    OwnCells& these = own.emplace_back();
    these.component = surface_components(surface.surface);
    for (std::size_t i = first_triangle; i < first_triangle + part.cells; ++i)
      if (piece.is_owned[as_size(made.surface.tet[i])] != 0) these.cells.push_back(i);
    first_vertex += part.vertices, first_triangle += part.cells;
  }
  return own;
}

}  // namespace

std::vector<WholeSurface> counted(const ModeSurfaces& made) {
  std::vector<WholeSurface> counts;
  for (const ModePart& part : made.parts)
    counts.push_back({part.mode.approx(), static_cast<std::int64_t>(part.invariants.components),
                      part.invariants.euler_characteristic, part.invariants.boundary_loops});
  return counts;
}

std::vector<WholeSurface> number_components(ModeSurfaces& made, const TensorGrid& grid,
                                            const Ranks& ranks, const WholeMesh& whole) {
  Numbers message;
  std::vector<OwnCells> own;
  ranks.together([&] { own = write_parts(made, grid.piece, message); });
  std::vector<std::vector<SentPart<SurfaceSeam>>> sent;
  std::size_t modes = 0;
  for (const Numbers& numbers : ranks.gather(message)) {
    sent.push_back(read_parts<SurfaceSeam>(numbers, seam_of_numbers));
    modes = std::max(modes, sent.back().size());
  }
  std::vector<WholeSurface> counts;
  Index first = 0;  // component of the mode
  for (std::size_t m = 0; m < modes; ++m) {
    WholeSurface& count = counts.emplace_back();
    std::vector<SurfaceSeam> seams(sent.size());
    for (std::size_t r = 0; r < sent.size(); ++r) {
      if (!sent[r].empty()) {
        seams[r] = std::move(sent[r][m].seam);
        count.mode = sent[r][m].mode;
      }
      seams[r].owned_ids = whole.owned_ids[r];
      seams[r].whole_tets = whole.tets;
    }
    const JoinedSeams joined = join_seams(seams);
    const auto total = joined.total();
    count.components = static_cast<std::int64_t>(joined.components.size());
    count.euler_characteristic = total.euler_characteristic;
    count.boundary_loops = total.boundary_loops;
    if (m < own.size()) {
      const auto& numbers = joined.numbers[as_size(ranks.own())];
      for (std::size_t i = 0; i < own[m].cells.size(); ++i)
        made.surface.component[own[m].cells[i]] = first + numbers[as_size(own[m].component[i])];
    }
    first += static_cast<Index>(joined.components.size());
  }
  return counts;
}

}  // namespace tensortopo::filters
