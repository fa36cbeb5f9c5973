// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// The certified screen: may a simplex hold the level at all?
///
/// The Lode angle arccos(mode)/3 is 1-Lipschitz in the angle between deviators as vectors of R^5
/// (Hoffman-Wielandt: the map from a symmetric matrix to its ordered eigenvalues is 1-Lipschitz,
/// and on unit deviators the Lode angle is the polar angle of the eigenvalue vector). A simplex
/// whose vertex tensors lie within an angle r < pi/2 of some tensor lies in a convex cone around
/// it, so its Lode angles differ from that tensor's by at most r.
namespace screen {

/// Bound on the error of an angle computed here in double: a cosine is wrong by less than
/// 64 u = 7.2e-15, |acos(x + e) - acos(x)| <= (pi/2) sqrt(2 e) < 1.9e-7, and `arc_cosine` adds 2.3e-8.
inline constexpr double kAngleError = 2.2e-7;

/// arccos(x) for x in [-1, 1], to within 2.3e-8: sqrt(1 - x) times a polynomial of degree 7 (Abramowitz and
/// Stegun, Handbook of Mathematical Functions, 4.4.46: 2e-8), with rounding.
inline double arc_cosine(double x) {
  const double y = std::abs(x);
  double p = -0.0012624911;
  for (const double c : {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874,
                         -0.2145988016, 1.5707963050})
    p = p * y + c;
  const double angle = std::sqrt(1 - y) * p;
  return x < 0 ? 3.141592653589793 - angle : angle;
}

/// arccos(mode)/3 of a nonzero deviator, to within `kAngleError`.
inline double lode_angle(const Deviator<double>& t) {
  const double p = norm_form(t);
  const double mode = std::sqrt(2.0) * determinant_form(t) / (p * std::sqrt(p));
  return arc_cosine(std::clamp(mode, -1.0, 1.0)) / 3;
}

/// Angle between two deviators, to within `kAngleError`.
inline double angle(const Deviator<double>& s, double norm_s, const Deviator<double>& t,
                    double norm_t) {
  return arc_cosine(std::clamp(norm_form(s, t) / (norm_s * norm_t), -1.0, 1.0));
}

/// True only if the level with the Lode angle given does not meet the cone of half angle
/// `radius` around a tensor with Lode angle `centre`.
inline bool excludes(double centre, double radius, double level) {
  return radius < 1.57 && std::abs(centre - level) > radius + 3 * kAngleError;
}

/// Cosine of an angle such that no tensor within it of one with this Lode angle is on the level; 2
/// if the level is too near. (By the error of that angle, at least 1e-3, the cosine changes by
/// more than 5e-10, which no rounding of a cosine makes up for.)
inline double clearance_cosine(double lode, double level) {
  const double gap = std::min(std::abs(lode - level), 1.57);
  return gap < 0.001 ? 2 : elementary::cos(gap - 3 * kAngleError);
}

/// A cone around the sum of some tensors that holds them all.
struct Cone {
  double centre = 0;  ///< Lode angle of the sum
  double radius = 4;  ///< half angle; 4 if there is no such cone that is convex
};

template <std::size_t Vertices>
Cone cone_around(const std::array<Deviator<double>, Vertices>& tensors) {
  Deviator<double> centre = tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) centre = centre + tensors[i];
  const double norm = std::sqrt(norm_form(centre));
  if (!(norm > 1e-3)) return {};
  double cosine = 1;
  for (const auto& t : tensors)
    cosine = std::min(cosine, norm_form(centre, t) / (norm * std::sqrt(norm_form(t))));
  if (!(cosine > 0.001)) return {};
  return {lode_angle(centre), arc_cosine(cosine)};
}

/// True only if the level does not meet the simplex: the cone is taken around the sum of the
/// vertex tensors.
template <std::size_t Vertices>
bool excludes(const std::array<Deviator<double>, Vertices>& tensors, double level) {
  const Cone cone = cone_around(tensors);
  return excludes(cone.centre, cone.radius, level);
}

/// Lode angles outside of which the level does not meet the simplex.
template <std::size_t Vertices>
std::array<double, 2> lode_range(const std::array<Deviator<double>, Vertices>& tensors) {
  const Cone cone = cone_around(tensors);
  if (!(cone.radius < 1.57)) return {-1, 4};
  return {cone.centre - cone.radius - 3 * kAngleError, cone.centre + cone.radius + 3 * kAngleError};
}

}  // namespace screen
}  // namespace tensortopo
