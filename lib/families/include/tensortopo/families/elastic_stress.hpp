// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/scalar_traits.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Stress of a point force in an infinite elastic body, times 8 pi (1 - nu) (Kelvin's solution).
///
///   T_ij = -((1 - 2 nu) (n_i F_j + n_j F_i - delta_ij n.F) + 3 n_i n_j n.F) / r^2,  n = x / r
///
/// In equilibrium but at the force; the traction on any sphere around it adds up to
/// -8 pi (1 - nu) F. Its mode depends on the angle between x and F only, so its mode surfaces are
/// circular cones around F. Tension is positive. Uses + - * / and the square root only.
/// @param x   position relative to the force, not zero
template <RealScalar Scalar>
SymmetricTensor<Scalar> kelvin_stress(const Vector3<Scalar>& x, const Vector3<Scalar>& force,
                                      const Scalar& poisson);

/// Stress of a force at the surface z = 0 of the elastic half space z > 0 along its normal +z,
/// times 2 pi (Boussinesq's solution); tension is positive.
///
/// With R^2 = r^2 + z^2: T_zz = -3 P z^3 / R^5, T_rz = -3 P r z^2 / R^5,
///   T_rr = P / R^2 ((1 - 2 nu) R / (R + z) - 3 r^2 z / R^3),
///   T_tt = P / R^2 (1 - 2 nu) (z / R - R / (R + z)).
/// In equilibrium, and no traction on z = 0. Uses + - * / and the square root only.
/// @param x  position relative to the load, x.z >= 0, not zero
template <RealScalar Scalar>
SymmetricTensor<Scalar> boussinesq_stress(const Vector3<Scalar>& x, const Scalar& load,
                                          const Scalar& poisson);

}  // namespace tensortopo
