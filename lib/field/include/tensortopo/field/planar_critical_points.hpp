// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/field/linear_field.hpp"

namespace tensortopo {

/// What the mode does at a critical point.
enum class CriticalType : signed char { extremum, saddle, undecided };

/// A critical point of the mode on the plane spanned by a triangle's field.
template <RealScalar Scalar>
struct PlanarCriticalPoint {
  /// Homogeneous barycentric weights: divide by `weight_sum` for the point; a sum of zero is a
  /// point at infinity of the plane. Largest magnitude 1; sum >= 0.
  std::array<Scalar, 3> weights{};
  /// The sum of the weights.
  Scalar weight_sum{};
  /// The tensor at these weights.
  Deviator<Scalar> tensor{};
  /// Its mode (at the point itself, as the sum is >= 0; at infinity the sign is a matter of
  /// choice).
  Scalar mode{};
  CriticalType type = CriticalType::undecided;  ///< maximum, minimum, saddle, or undecided
};

/// All non-degenerate critical points of the mode on the plane of a triangle (at most three).
///
/// Let N run through the plane of tensors orthogonal to the three vertex tensors. T is critical
/// exactly if T ~ N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N for an N at which this T is orthogonal
/// to that plane again: a binary cubic in N. (If N is degenerate this T vanishes, and a neutral
/// tensor whose kernel is N's dominant eigenvector takes its place.) Each is polished by Newton's
/// method. There are no spurious solutions and no chart: points at infinity are found like any
/// other. Empty if the cubic vanishes identically, which happens on planes of symmetry (all tensors
/// share an eigenvector; critical points are then degenerate and fill a conic), or if the three
/// tensors are dependent. `undecided` where the Hessian is singular to rounding.
template <RealScalar Scalar>
std::vector<PlanarCriticalPoint<Scalar>> nondegenerate_critical_points(
    const TriangleField<Scalar>& field);

/// The degenerate points (mode 1 or -1) on the plane of a triangle.
template <RealScalar Scalar>
struct PlanarDegeneratePoints {
  /// The isolated points: 2 or 4 generically (fewer only where some coincide or fill a conic).
  std::vector<PlanarCriticalPoint<Scalar>> points;
  /// False if, to rounding, a whole conic of degenerate points lies in the plane (planes of
  /// symmetry).
  bool isolated = true;
};

/// Points e e^T - I/3 in the field, where e is a common zero of the forms e.N e for all N
/// orthogonal to the field. These always exist in the projective plane. Empty if the tensors are
/// dependent.
template <RealScalar Scalar>
PlanarDegeneratePoints<Scalar> degenerate_points(const TriangleField<Scalar>& field);

}  // namespace tensortopo
