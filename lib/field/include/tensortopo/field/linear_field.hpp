// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// The linear deviator field of a tetrahedron, as its vertex tensors.
///
/// Linear interpolation commutes with taking deviators, and the mode sees deviators only.
template <RingScalar Scalar>
struct TetrahedronField {
  std::array<Deviator<Scalar>, 4> vertex{};  ///< at the vertices

  /// The tensor at barycentric weights. Homogeneous weights (of any sum) give a multiple of the
  /// tensor, of the opposite sign if their sum is negative.
  constexpr Deviator<Scalar> at(const std::array<Scalar, 4>& barycentric) const {
    return barycentric[0] * vertex[0] + barycentric[1] * vertex[1] + barycentric[2] * vertex[2] +
           barycentric[3] * vertex[3];
  }
};

/// The linear deviator field of a triangle; like TetrahedronField.
template <RingScalar Scalar>
struct TriangleField {
  std::array<Deviator<Scalar>, 3> vertex{};  ///< at the vertices

  /// The tensor at barycentric weights, of any sum.
  constexpr Deviator<Scalar> at(const std::array<Scalar, 3>& barycentric) const {
    return barycentric[0] * vertex[0] + barycentric[1] * vertex[1] + barycentric[2] * vertex[2];
  }
};

}  // namespace tensortopo
