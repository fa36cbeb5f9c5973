// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// The linear field of one tetrahedron in space, wider than double, times a power of two.
class FieldInSpace {
 public:
  FieldInSpace(const ScaledField<double>& field, std::size_t tet);

  /// sqrt(1 - mode^2) at a place.
  double distance_from_degenerate(const Vector3<double>& x) const;

  /// The separation of wedges and trisectors at a place with this dominant eigenvector; see
  /// CurveMesh.
  double separation(const Vector3<double>& x, const Vector3<double>& dominant) const;

 private:
  using Vector = Vector3<Extended>;

  Deviator<Extended> at(const Vector3<double>& x) const;
  /// The derivative of the field along a direction.
  Deviator<Extended> along(const Vector& direction) const;

  Vector origin_{};
  std::array<Vector, 4> gradient_{};  ///< of the barycentric coordinates
  std::array<Deviator<Extended>, 4> tensors_{};
};

}  // namespace tensortopo
