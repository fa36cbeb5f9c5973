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

/// The curvature of the zero set of a function, from its gradient and Hessian at a point of it: the
/// Hessian, projected on the tangent plane, over the length of the gradient.
/// @return nothing if the gradient vanishes
template <RealScalar Scalar>
std::optional<LevelCurvature<Scalar>> level_curvature(const Vector3<Scalar>& gradient,
                                                      const SymmetricTensor<Scalar>& hessian);

/// The curvature of the level through a point of a tetrahedron (or elsewhere in its linear field),
/// by the derivatives in `level_form.hpp`.
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
