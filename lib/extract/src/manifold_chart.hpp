// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo {

/// A plane chart of the real domain of the sphere, unfolded along the boundary of the complex
/// domain.
///
/// From the sphere to space the lift behaves like a square root at that boundary, and the images of
/// face curves touch it. So the chart takes the square root: near the boundary its distance from
/// it is proportional to sqrt(Delta), and curves that are transversal on the surface are
/// transversal in the chart.
/// - Above the bifurcation value the real domain is one annulus: theta stays, and
///   cos eta' = cos eta / cos eta_boundary(theta); then polar coordinates.
/// - Below it the complex domain is four ovals E = const around the singularities, where
///   E^2 = p sin^2 theta + q sin^2 eta: rays from the singularity stay, E is stretched by a root;
///   then stereographic projection from a singularity, which no region holds.
class ManifoldChart {
 public:
  explicit ManifoldChart(const MediumEigenvectorManifold<double>& manifold) : manifold_(manifold) {
    pole_ = manifold.sphere_point(0, 0);
    const auto& e = manifold.characteristic().eigenvectors;
    first_ = e[1];
    second_ = cross(pole_, first_);
  }

  std::array<double, 2> operator()(const Vector3<double>& v) const {
    const auto at = manifold_.sphero_conal(v);
    return at_coordinates(at.theta, at.eta);
  }

  /// The image of the point with these sphero-conal coordinates, 0 <= eta <= pi.
  std::array<double, 2> at_coordinates(double theta, double eta) const {
    const double p = manifold_.p(), q = manifold_.q(), c = manifold_.c();
    const double sin_theta = std::sin(theta), cos_theta = std::cos(theta);
    const double sin_eta = std::sin(eta), cos_eta = std::cos(eta);
    if (manifold_.single_loop()) {
      const double sin2_boundary = std::max(0.0, (c - p * sin_theta * sin_theta) / q);
      const double cos_boundary = std::sqrt(std::max(kTiny, 1 - sin2_boundary));
      const double cosine = std::clamp(cos_eta / cos_boundary, -1.0, 1.0);
      const double radius = std::exp(std::acos(cosine) - 1.5707963267948966);
      return {radius * cos_theta, radius * sin_theta};
    }
    const double x = std::sqrt(p) * std::abs(sin_theta), y = std::sqrt(q) * std::abs(sin_eta);
    const double e = std::hypot(x, y), root_c = std::sqrt(c);
    double stretched = e;
    if (e > 0) {
      const double to_side = std::min(x > 0 ? std::sqrt(p) / x : 1e300,
                                      y > 0 ? std::sqrt(q) / y : 1e300);
      const double e_max = to_side * e;
      const double range = e_max * e_max - c;
      if (range > 0)
        stretched = root_c + (e_max - root_c) * std::sqrt(std::max(0.0, e * e - c) / range);
    }
    const double k = e > 0 ? stretched / e : 1.0;
    const double new_sin_theta = p > 0 ? std::min(1.0, k * std::abs(sin_theta)) : 0;
    const double new_sin_eta = std::min(1.0, k * std::abs(sin_eta));
    const auto w = manifold_.sphere_point(
        std::copysign(new_sin_theta, sin_theta),
        std::copysign(std::sqrt(1 - new_sin_theta * new_sin_theta), cos_theta), new_sin_eta,
        std::copysign(std::sqrt(1 - new_sin_eta * new_sin_eta), cos_eta));
    const double height = std::max(kTiny, 1 - dot(w, pole_));
    return {dot(w, first_) / height, dot(w, second_) / height};
  }

 private:
  /// Keeps a division finite; no region reaches a pole or a whole meridian of the complex domain.
  static constexpr double kTiny = std::numeric_limits<double>::min();

  const MediumEigenvectorManifold<double>& manifold_;
  Vector3<double> pole_, first_, second_;
};

}  // namespace tensortopo
