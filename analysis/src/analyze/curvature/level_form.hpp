// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// A function that a level of the mode is the zero set of, with its derivatives at a point.
///
/// With the forms P and Q of `deviator.hpp` the mode is a multiple of Q / P^(3/2). Let k be the
/// value of this quotient at the point: F = Q - k P^(3/2) vanishes on the level through the point,
/// and grows with the mode. Of a linear field T(x) = T + x_i U_i, with c = Q / P and brackets for
/// the polar form of P,
///   F_i = DQ(U_i) - 3 c <T, U_i>
///   F_ij = D2Q(U_i, U_j) - 3 c (<U_i, U_j> + <T, U_i> <T, U_j> / P)
/// and along a vector v, with U = v_i U_i,
///   D3F(v, v, v) = 6 Q(U) - 3 (c / P) <T, U> (3 <U, U> - <T, U>^2 / P).
template <class Scalar>
struct LevelForm {
  Vector3<Scalar> gradient{};
  SymmetricTensor<Scalar> hessian{};

  Deviator<Scalar> tensor{};                   ///< T
  std::array<Deviator<Scalar>, 3> derivative;  ///< U_i
  Scalar norm{};                               ///< P(T)
  Scalar ratio{};                              ///< c

  /// How F changes with the tensor, DQ(U) - 3 c <T, U>.
  Scalar along(const Deviator<Scalar>& u) const;
  /// D3F(v, v, v).
  Scalar third(const Vector3<Scalar>& v) const;
};

/// F of the linear field of a tetrahedron, at any point.
/// @return nothing if the deviator vanishes there, or the tetrahedron is flat
template <RealScalar Scalar>
std::optional<LevelForm<Scalar>> level_form(const std::array<Vector3<Scalar>, 4>& corners,
                                            const std::array<SymmetricTensor<Scalar>, 4>& tensors,
                                            const Vector3<Scalar>& point);

/// The same from the tensor and its derivatives.
template <RealScalar Scalar>
std::optional<LevelForm<Scalar>> level_form(const Deviator<Scalar>& tensor,
                                            const std::array<Deviator<Scalar>, 3>& derivative);

/// The weights of the corners at a point; nothing if the tetrahedron is flat.
template <RealScalar Scalar>
std::optional<std::array<Scalar, 4>> barycentric_coordinates(
    const std::array<Vector3<Scalar>, 4>& corners, const Vector3<Scalar>& point);

}  // namespace tensortopo
