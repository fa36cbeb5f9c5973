// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "grids/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bytes/format_error.hpp"
#include "bytes/input_file.hpp"

namespace tensortopo::detail {
namespace {

/// Calls take(corners) for each cube: its corners as numbers of samples, as VTK orders a voxel's.
template <class Take>
void each_cube(const Lattice& lattice, const Take& take) {
  const auto [nx, ny, nz] = lattice.size;
  for (std::size_t k = 0; k + 1 < nz; ++k)
    for (std::size_t j = 0; j + 1 < ny; ++j)
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        const std::size_t a = i + nx * (j + ny * k), b = a + nx * ny;
        take(std::array<std::size_t, 8>{a, a + 1, a + nx, a + nx + 1, b, b + 1, b + nx,
                                        b + nx + 1});
      }
}

bool is_whole(const std::vector<char>& kept, const std::array<std::size_t, 8>& corners) {
  return kept.empty() || std::all_of(corners.begin(), corners.end(),
                                     [&](std::size_t v) { return kept[v] != 0; });
}

}  // namespace

std::size_t Lattice::points() const {
  return kept.empty() ? samples()
                      : static_cast<std::size_t>(std::count(kept.begin(), kept.end(), char{1}));
}

std::size_t Lattice::cubes() const {
  return (std::max<std::size_t>(size[0], 1) - 1) * (std::max<std::size_t>(size[1], 1) - 1) *
         (std::max<std::size_t>(size[2], 1) - 1);
}

void check_lattice(const Lattice& lattice) {
  std::uint64_t samples = 1;
  for (const std::size_t n : lattice.size) {
    if (n < 2)
      throw FormatError("has " + std::to_string(n) +
                        " samples along an axis; a field in space has 2 at least along each");
    if (n > INT32_MAX || samples > INT32_MAX / n) throw FormatError("has too many samples");
    samples *= n;
  }
  require_memory(samples, 6 * lattice.cubes(), 8 * lattice.cubes());
  const auto& m = lattice.to_space;
  const auto minor = [&](std::size_t i, std::size_t j) { return m[1][i] * m[2][j] - m[1][j] * m[2][i]; };
  const double volume = m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1);
  if (!std::isfinite(volume) || volume == 0)
    throw FormatError("places its samples in one plane, or at infinity");
}

void keep_whole_cubes(Lattice& lattice) {
  if (lattice.kept.empty()) return;
  std::vector<char> used(lattice.kept.size(), 0);
  each_cube(lattice, [&](const auto& corners) {
    if (!is_whole(lattice.kept, corners)) return;
    for (const std::size_t v : corners) used[v] = 1;
  });
  lattice.kept = std::move(used);
}

LatticeCells cells_of(const Lattice& lattice) {
  LatticeCells cells;
  const auto [nx, ny, nz] = lattice.size;
  cells.coordinates.reserve(3 * lattice.points());
  std::vector<std::int64_t> number(lattice.kept.empty() ? 0 : lattice.samples(), -1);
  std::size_t sample = 0;
  std::int64_t next = 0;
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i, ++sample) {
        if (!lattice.kept.empty()) {
          if (lattice.kept[sample] == 0) continue;
          number[sample] = next++;
        }
        const std::array<double, 3> index{
            static_cast<double>(lattice.first[0] + static_cast<std::int64_t>(i)),
            static_cast<double>(lattice.first[1] + static_cast<std::int64_t>(j)),
            static_cast<double>(lattice.first[2] + static_cast<std::int64_t>(k))};
        for (const auto& row : lattice.to_space)
          cells.coordinates.push_back(row[0] * index[0] + row[1] * index[1] + row[2] * index[2] +
                                      row[3]);
      }
  each_cube(lattice, [&](const auto& corners) {
    if (!is_whole(lattice.kept, corners)) return;
    for (const std::size_t v : corners)
      cells.connectivity.push_back(number.empty() ? static_cast<std::int64_t>(v) : number[v]);
    ++cells.voxels;
  });
  return cells;
}

}  // namespace tensortopo::detail
