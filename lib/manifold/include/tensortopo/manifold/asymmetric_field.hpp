// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// A 2x2 matrix [[a, b], [c, d]].
template <RealScalar Scalar>
struct Matrix2 {
  /// Row by row.
  Scalar a{}, b{}, c{}, d{};
};

/// Orthonormal (e1, e2) with e1 x e2 = v for a unit vector v.
template <RealScalar Scalar>
std::array<Vector3<Scalar>, 2> plane_basis(const Vector3<Scalar>& v);

/// The paper's asymmetric tensor A(v) = R(theta/2 + pi/4) T'(v) R(theta/2 - pi/4).
///
/// `basis` is (e1, e2) with e1 x e2 = v: a left-handed basis gives A(-v) instead, whose
/// eigenvectors are the same with major and minor exchanged. T' is the characteristic tensor
/// restricted to the plane, theta >= 0 belongs to |mu|. Real eigenvectors are the dominant
/// eigenvectors of the tensors of mode
/// +-mu with medium eigenvector +-v.
template <RealScalar Scalar>
Matrix2<Scalar> asymmetric_tensor(const CharacteristicTensor<Scalar>& characteristic,
                                  const ModeParameter<Scalar>& mode,
                                  const std::array<Vector3<Scalar>, 2>& basis);

/// Real eigenvalues and unit eigenvectors of a 2x2 matrix, major first; nothing if they are
/// complex.
template <RealScalar Scalar>
struct Eigensystem2 {
  std::array<Scalar, 2> values{};                  ///< the larger one first
  std::array<std::array<Scalar, 2>, 2> vectors{};  ///< of unit length, sign arbitrary
};
template <RealScalar Scalar>
std::optional<Eigensystem2<Scalar>> real_eigensystem(const Matrix2<Scalar>& matrix);

}  // namespace tensortopo
