// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// The point of a simplex whose weights refer to scaled vertex tensors.
///
/// The tensor sum w_i 2^{e_i} T_i is, up to a factor, that of the barycentric coordinates
/// w_i 2^{e_i} / sum_j w_j 2^{e_j}. Evaluated wider than double where the scalar is double, so that
/// what remains is the rounding of the result.
template <class Scalar, std::size_t Vertices>
Vector3<double> position_at(const std::array<Scalar, Vertices>& weights,
                            const std::array<int, Vertices>& exponents,
                            const std::array<Vector3<double>, Vertices>& points) {
  using Wide = std::conditional_t<std::is_same_v<Scalar, double>, Extended, Scalar>;
  using std::ldexp;
  const int largest = *std::max_element(exponents.begin(), exponents.end());
  Wide total(0), x(0), y(0), z(0);
  for (std::size_t i = 0; i < Vertices; ++i) {
    const Wide w = exponents[i] == largest ? Wide(weights[i])
                                           : Wide(ldexp(Wide(weights[i]), exponents[i] - largest));
    total += w;
    x += w * Wide(points[i].x);
    y += w * Wide(points[i].y);
    z += w * Wide(points[i].z);
  }
  return {static_cast<double>(x / total), static_cast<double>(y / total),
          static_cast<double>(z / total)};
}

}  // namespace tensortopo
