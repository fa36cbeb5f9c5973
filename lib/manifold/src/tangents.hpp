// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo {

/// What a vector of the sphere sees of the singularities.
template <RealScalar Scalar>
struct MediumEigenvectorManifold<Scalar>::Tangents {
  /// The singularities' components across v; their lengths are the sines of the angles from v.
  Vector3<Scalar> first{}, second{};
  /// The product of the two lengths: (d+ - d-) / (b1 - b3).
  Scalar product{};
  /// (b1 - b3) / 2.
  Scalar half_gap{};
  /// v . T v = -(d+ + d-).
  Scalar alpha{};
};

/// The component of a unit vector s across a unit vector v, accurate relative to its own length
/// also where s is close to v or to -v: it is that of the difference, which subtraction gives
/// exactly there, and the lengths of s and v, which are 1 only to rounding, do not come in.
template <RealScalar Scalar>
Vector3<Scalar> across(const Vector3<Scalar>& s, const Vector3<Scalar>& v) {
  const Vector3<Scalar> near = dot(s, v) >= Scalar(0) ? v : -v;
  const Vector3<Scalar> difference = s - near;
  return difference - dot(difference, near) * near;
}

}  // namespace tensortopo
