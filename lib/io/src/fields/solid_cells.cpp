// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/solid_cells.hpp"

#include <array>
#include <cmath>

#include "fields/quadratic_cells.hpp"
#include "grids/cell_kind.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo::detail {

using Index = TetMesh::Index;

std::vector<char> ghost_cells(const RawGrid& grid) {
  constexpr unsigned duplicate = 1, hidden = 32;
  std::vector<char> ghosts;
  for (const ArraySource& source : grid.cell_data) {
    if (source.name != "vtkGhostType" || source.components != 1) continue;
    ghosts.clear();
    for (const double mark : source.values())
      ghosts.push_back(mark > 0 && mark < 256 &&
                       (static_cast<unsigned>(mark) & (duplicate | hidden)) != 0);
  }
  return ghosts;
}

std::vector<std::size_t> solid_cells(const RawGrid& grid) {
  const std::vector<char> ghosts = ghost_cells(grid);
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < grid.cells(); ++c)
    if ((ghosts.empty() || ghosts[c] == 0) &&
        cell_kind(grid.types[c]).use != CellKind::Use::skip)
      cells.push_back(c);
  return cells;
}

std::size_t corners_of(const RawGrid& grid, std::size_t cell) {
  const QuadraticKind kind = quadratic_kind(grid.types[cell]);
  const auto nodes = static_cast<std::size_t>(grid.offsets[cell + 1] - grid.offsets[cell]);
  return kind.nodes > 0 && nodes >= kind.corners ? kind.corners : nodes;
}

std::vector<Index> vertices_of(const RawGrid& grid, std::size_t cell,
                               const std::vector<Index>& map) {
  std::vector<Index> vertices;
  vertices_of(grid, cell, map, vertices);
  return vertices;
}

void vertices_of(const RawGrid& grid, std::size_t cell, const std::vector<Index>& map,
                 std::vector<Index>& vertices) {
  vertices.clear();
  for (std::int64_t i = grid.offsets[cell]; i < grid.offsets[cell + 1]; ++i)
    vertices.push_back(map[as_size(grid.connectivity[as_size(i)])]);
}

double cell_volume(const TetMesh& mesh, std::uint8_t vtk_type, std::span<const Index> corners) {
  const QuadraticKind quadratic = quadratic_kind(vtk_type);
  const std::uint8_t type = quadratic.nodes > 0 ? quadratic.linear_type : vtk_type;
  const CellKind kind = cell_kind(type);
  if (kind.corners == 0 || corners.size() < kind.corners) return 0;
  std::vector<std::array<Index, 4>> tets;
  if (kind.use == CellKind::Use::tetrahedron)
    tets.push_back({corners[0], corners[1], corners[2], corners[3]});
  else
    split_cell(type, corners.first(kind.corners), tets);
  double volume = 0;
  for (const auto& t : tets) {
    const auto& p = mesh.points[as_size(t[0])];
    const auto edge = [&](std::size_t i) { return mesh.points[as_size(t[i])] - p; };
    volume += std::abs(dot(edge(1), cross(edge(2), edge(3)))) / 6;
  }
  return volume;
}

}  // namespace tensortopo::detail
