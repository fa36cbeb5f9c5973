// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::baselines {

/// A cubic on a triangle by its Bernstein coefficients; see `cubic_place` for their order.
using Cubic = std::array<double, 10>;

/// Where the coefficient of corner 0^i corner 1^j corner 2^k is, i + j + k = 3.
constexpr std::size_t cubic_place(std::size_t j, std::size_t k) {
  constexpr std::array<std::size_t, 4> row{0, 4, 7, 9};
  return row[k] + j;
}

/// The neutral surface of a linear field, parameterized by the medium eigenvector.
///
/// A traceless neutral tensor T with medium eigenvector v is one with T v = 0. For the linear field
/// of a tetrahedron with vertex tensors T_i that is b_0 T_0 v + .. + b_3 T_3 v = 0: three equations
/// for the weights b of the one place, so by Cramer's rule b is a cubic form of v (and b(-v) =
/// -b(v): v and -v are one place). It is inside the tetrahedron iff no two weights have opposite
/// signs. All four vanish at the singularities, two directions each of which has a whole line.
/// Parameterization by the medium eigenvector: Roy et al., "Robust and fast extraction of 3D
/// symmetric tensor field topology", 2019. Cramer's form of it is ours.
class NeutralMap {
 public:
  explicit NeutralMap(const std::array<Deviator<double>, 4>& tensors);

  std::array<double, 4> weights(const Vector3<double>& v) const;

  /// Their derivatives at v along d.
  std::array<double, 4> slopes(const Vector3<double>& v, const Vector3<double>& d) const;

  /// The weights on the triangle of directions with these corners.
  std::array<Cubic, 4> on(const std::array<Vector3<double>, 3>& corners) const;

  /// v.T_i v: at the place of v the mode grows along x iff the sum of these over i, times the
  /// growth of the i-th barycentric coordinate along x, is negative.
  std::array<double, 4> squares(const Vector3<double>& v) const;

 private:
  std::array<SymmetricTensor<double>, 4> tensors_;
};

/// The same cubic with the corners (a, b, c) named (b, c, a).
Cubic turned(const Cubic& cubic);

/// Cuts a triangle of corners a, b, c across the middle m of its first edge: the cubic on (c, a, m)
/// and on (b, c, m).
std::array<Cubic, 2> halves(const Cubic& cubic);

}  // namespace tensortopo::baselines
