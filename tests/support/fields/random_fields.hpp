// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tensortopo/families/random_source.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

using TetTensors = std::array<SymmetricTensor<double>, 4>;

/// The seeded random numbers of `RandomSource`, with another normal distribution: with all bits in
/// use, and the same on every platform.
///
/// The standard fixes the last digits neither of log nor of cos, so normal variates come from a
/// Box-Muller step that is rounded to 24 bits after the point and then filled with random lower
/// bits.
class Random : private RandomSource {
 public:
  explicit Random(std::uint64_t seed) : RandomSource(seed) {}
  using RandomSource::integer;
  using RandomSource::quaternion;
  using RandomSource::uniform;

  /// Standard normal.
  double normal();
  /// Six independent standard normal components.
  SymmetricTensor<double> tensor();
  /// Four independent tensors: the hardest linear fields, with no smoothness to lean on.
  TetTensors tet_tensors();
};

/// One tetrahedron with vertices 0, e_x, e_y, e_z and these tensors.
TetMesh reference_tet_mesh(const TetTensors& tensors);

/// One tetrahedron with these vertices, reordered if needed so that it is positively oriented.
TetMesh single_tet_mesh(const std::array<Vector3<double>, 4>& points, const TetTensors& tensors);

/// The cube [0, n]^3 cut in unit cubes of six tetrahedra each, positively oriented and
/// conforming; tensors zero.
TetMesh cube_mesh(int n);

/// Gives every vertex an independent normal tensor.
void fill_with_normal_tensors(TetMesh& mesh, std::uint64_t seed);

/// Gives every vertex the value of one smooth random field: a constant and `waves` plane waves
/// with normal tensor amplitudes and wave lengths of at least `shortest`.
void fill_with_smooth_tensors(TetMesh& mesh, std::uint64_t seed, int waves = 4,
                              double shortest = 4);

/// The tensor with every entry rounded to so many binary places after the point.
SymmetricTensor<double> rounded(const SymmetricTensor<double>& t, int places);

/// Number, tensor, four tensors as text that reads back bit for bit (hexadecimal floats).
std::string exact_text(double value);
std::string exact_text(const SymmetricTensor<double>& t);
std::string exact_text(const TetTensors& tensors);

}  // namespace tensortopo::test
