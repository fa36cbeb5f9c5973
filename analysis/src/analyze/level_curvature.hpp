// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// How a level of the mode bends at a point.
///
/// The normal is the unit gradient of the mode, and the curvature tensor its derivative along the
/// level: positive principal curvatures where normals spread. (It maps the normal to zero.)
template <class Scalar>
struct LevelCurvature {
  Vector3<Scalar> normal{};
  SymmetricTensor<Scalar> tensor{};             ///< in 1 / length
  std::array<Scalar, 2> principal{};            ///< the larger one first
  std::array<Vector3<Scalar>, 2> directions{};  ///< unit, with the normal right-handed

  Scalar mean() const { return (principal[0] + principal[1]) / Scalar(2); }
  Scalar gauss() const { return principal[0] * principal[1]; }
};

/// The curvature of the level through a point of a tetrahedron (or elsewhere in its linear field).
///
/// With the forms P and Q of `deviator.hpp`, T(x) = T + x_i U_i and c = Q / P at the point, the
/// gradient is G_i = DQ(U_i) - 3 c <T, U_i>, and on the tangent plane the Hessian is
/// D2Q(U_i, U_j) - 3 c (<U_i, U_j> + <T, U_i> <T, U_j> / P), both over P^(3/2), brackets being the
/// polar form of P. The curvature tensor is the second, projected, over the length of the first.
/// @return nothing if the deviator or the gradient vanishes, or the tetrahedron is flat
template <RealScalar Scalar>
std::optional<LevelCurvature<Scalar>> level_curvature(
    const std::array<Vector3<Scalar>, 4>& corners,
    const std::array<SymmetricTensor<Scalar>, 4>& tensors, const Vector3<Scalar>& point);

/// The principal curvatures and directions of a tensor on the plane across a unit normal.
template <RealScalar Scalar>
LevelCurvature<Scalar> curvature_of(const Vector3<Scalar>& normal,
                                    const SymmetricTensor<Scalar>& tensor);

/// Two unit vectors that form a right-handed basis with a unit normal, in the order given.
template <RealScalar Scalar>
std::array<Vector3<Scalar>, 2> tangents(const Vector3<Scalar>& normal);

}  // namespace tensortopo
