// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plane/plane.hpp"

namespace tensortopo::theory {

/// A curve of tensors with polynomial weights, and the parameters at which it meets the points in
/// question.
struct PointFamily {
  Polynomial parameters;  ///< square-free
  /// Of the plane's three basis tensors; not all zero at a zero of `parameters`.
  Vector3<Polynomial> weights;

  /// The number of points over the complex numbers; -1 if nothing is known.
  int count() const { return parameters.degree(); }
  SymmetricTensor<Polynomial> tensor(const Plane& plane) const {
    return combined(plane.basis, weights);
  }
  Polynomial weight_sum() const { return weights.x + weights.y + weights.z; }
};

/// Why a family is not there.
enum class Position : unsigned char {
  general,       ///< it is there
  not_isolated,  ///< a curve of complex solutions
  coincident,    ///< solutions that are not simple, or not apart in any chart tried
  isotropic,     ///< a complex N at which the cubic of the pencil and tr N^2 are zero
};

/// The same up to a positive factor, with the smallest integers.
Vector3<Polynomial> primitive(const Vector3<Polynomial>& v);

/// The words for a hypothesis that is lacking.
std::string words(Position position);

/// The critical points, from the gradient of the determinant alone.
struct CriticalSystem {
  Position position = Position::coincident;
  int solutions = 0;     ///< of two equations of the three, in a general chart
  int spurious = 0;      ///< of these, those that are not critical
  PointFamily critical;  ///< the others
};
CriticalSystem critical_system(const Plane& plane);

/// The degenerate tensors: those along e e^T - |e|^2 I / 3 for common zeros e of the two forms of
/// the complement.
struct DegenerateSystem {
  Position position = Position::coincident;
  PointFamily points;
};
DegenerateSystem degenerate_system(const Plane& plane);

/// A real critical point: signs of numbers that decide what it is.
struct CriticalKind {
  Sign morse = Sign::zero;       ///< positive for extrema, negative for saddles
  Sign degeneracy = Sign::zero;  ///< zero for degenerate tensors, otherwise positive
  Sign weight_sum = Sign::zero;  ///< zero for points at infinity
};
/// Those of a family, in the order of their parameters.
std::vector<CriticalKind> real_points(const Plane& plane, const PointFamily& family);

/// How many real points of each sort there are.
struct CriticalCounts {
  int extrema = 0, saddles = 0, singular = 0;
  int degenerate = 0, nondegenerate_extrema = 0, at_infinity = 0;

  friend bool operator==(const CriticalCounts&, const CriticalCounts&) = default;
};
CriticalCounts count(const std::vector<CriticalKind>& points);
std::string text(const CriticalCounts& counts);

}  // namespace tensortopo::theory
