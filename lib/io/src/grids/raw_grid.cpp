// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "grids/raw_grid.hpp"

#include <utility>

#include "bytes/format_error.hpp"

namespace tensortopo::detail {

void fill_lattice(RawGrid& grid) {
  if (!grid.lattice) return;
  check_lattice(*grid.lattice);
  LatticeCells cells = cells_of(*grid.lattice);
  constexpr std::uint8_t voxel = 11;
  grid.coordinates = std::move(cells.coordinates);
  grid.connectivity = std::move(cells.connectivity);
  grid.types.assign(cells.voxels, voxel);
  grid.offsets.resize(cells.voxels + 1);
  for (std::size_t c = 0; c < grid.offsets.size(); ++c)
    grid.offsets[c] = static_cast<std::int64_t>(8 * c);
  grid.lattice.reset();
  grid.is_regular = true;
}

void check_cells(const RawGrid& grid) {
  const std::size_t cells = grid.cells();
  if (grid.offsets.size() != cells + 1)
    throw FormatError("has " + std::to_string(cells) + " cell types for " +
                      std::to_string(grid.offsets.size() - 1) + " cells");
  const auto points = static_cast<std::int64_t>(grid.points());
  const auto corners = static_cast<std::int64_t>(grid.connectivity.size());
  for (std::size_t c = 0; c < cells; ++c) {
    const std::int64_t begin = grid.offsets[c], end = grid.offsets[c + 1];
    if (begin < 0 || end < begin || end > corners)
      throw FormatError("cell offsets do not rise within the connectivity (cell " +
                        std::to_string(c) + ")");
    for (std::int64_t i = begin; i < end; ++i) {
      const std::int64_t v = grid.connectivity[static_cast<std::size_t>(i)];
      if (v < 0 || v >= points)
        throw FormatError("a cell names point " + std::to_string(v) + " of " +
                          std::to_string(points) + " points (cell " + std::to_string(c) + ")");
    }
  }
}

}  // namespace tensortopo::detail
