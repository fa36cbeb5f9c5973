// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tensortopo::detail {

/// Samples on a regular lattice, the first axis fastest, and the cubes between them.
struct Lattice {
  std::array<std::size_t, 3> size{};   ///< samples along each axis
  std::array<std::int64_t, 3> first{};  ///< index of the first sample
  /// Row r: coordinate r of the sample (i, j, k) is the scalar product with (i, j, k, 1).
  std::array<std::array<double, 4>, 3> to_space{};
  std::vector<char> kept;  ///< one for each sample; empty if all are

  std::size_t samples() const { return size[0] * size[1] * size[2]; }
  /// The samples that are kept.
  std::size_t points() const;
  std::size_t cubes() const;
};

/// Throws FormatError for sizes that cannot be, lattices without cubes, and axes in one plane.
void check_lattice(const Lattice& lattice);

/// Keeps only samples that belong to a cube whose corners are all kept.
void keep_whole_cubes(Lattice& lattice);

/// The cells of a lattice as voxels of VTK, and the samples that are kept, in their order.
struct LatticeCells {
  std::vector<double> coordinates;
  std::vector<std::int64_t> connectivity;  ///< eight corners for each voxel
  std::size_t voxels = 0;
};
LatticeCells cells_of(const Lattice& lattice);

}  // namespace tensortopo::detail
