// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// From a tensor in the span of a field of rank 4 to the place where the field takes it.
///
/// The weights b of a tensor t solve t = b_0 T_0 + .. + b_3 T_3. With sum c = b_0 + .. + b_3, the
/// field at barycentric coordinates b / c is t / c: it has the mode of t if c > 0 and the opposite
/// mode if c < 0, and c = 0 is a place at infinity. The place is inside the tetrahedron iff all b
/// have one sign.
template <RealScalar Scalar>
class FieldLift {
 public:
  /// Throws std::invalid_argument if elimination meets a zero pivot (rank below 4).
  explicit FieldLift(const TetrahedronField<Scalar>& field);

  /// Nothing instead: deviators that are independent may not be so in the scalar's rounding.
  static std::optional<FieldLift> of(const TetrahedronField<Scalar>& field);

  /// The weights of a tensor; its component across the span, if any, is dropped.
  std::array<Scalar, 4> weights(const Deviator<Scalar>& t) const;
  /// The same of its deviator.
  std::array<Scalar, 4> weights(const SymmetricTensor<Scalar>& t) const {
    return weights(deviator(t));
  }

 private:
  FieldLift() = default;
  bool build(const TetrahedronField<Scalar>& field);

  /// Row i holds the i-th dual tensor in orthonormal coordinates.
  std::array<std::array<Scalar, 5>, 4> dual_{};
};

}  // namespace tensortopo
