// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

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
/// - Below it the complex domain is four ovals E^2 = c around the singularities, where
///   E^2 = p sin^2 theta + q sin^2 eta is nearly proportional to the distance from the
///   singularity. Around an oval the polar angle is turned by asin(c / E^2): the angle between
///   half_sum and half_difference, by which the dominant eigenvector would otherwise turn on its
///   way from far away to the boundary, a right angle within a few radii of the oval. So in the
///   chart a point beside a small oval is beside that of the boundary to which it is close in
///   space. E is stretched to R + (E_side - R) sqrt((E^4 - c^2) / (E_side^4 - c^2)), with an R that
///   is not small even if the oval is: next to mode 0 its points are all of a line in space. Where
///   ovals are not small nothing is turned, R is the oval's E, and the root is that of E^2 - c.
///   Then stereographic projection from a singularity, which no region holds.
class ManifoldChart {
 public:
  using Point = std::array<double, 2>;
  using Manifold = MediumEigenvectorManifold<double>;

  explicit ManifoldChart(const Manifold& manifold);

  /// The direction of an angle.
  struct Direction {
    double cosine = 1, sine = 0;
  };

  Point operator()(const Vector3<double>& v) const;

  /// The image of sign * boundary_point(loop, phi), as accurate as phi: next to mode 0 the vector
  /// itself has only a few digits of its place along the oval.
  Point at_boundary(const BoundaryPosition<double>& at) const;

  /// A line of a grid over one of the quadrants of the signs of cos theta and cos eta (above the
  /// bifurcation value: over the annulus, for quadrant 0 only): from the boundary, at this part of
  /// the way around it, across (above the bifurcation value: to the boundary again).
  struct Ray {
    int quadrant;
    Direction at;  ///< its half angle; of an annulus theta
    double end;    ///< E^2 where it ends; of an annulus cos eta where it begins
  };
  /// @param around 0 to 1 along the boundary, once around it
  Ray ray(int quadrant, double around) const;
  /// @param across 0 to 1 along the ray
  Vector3<double> vector_at(const Ray& ray, double across) const;
  /// Its image.
  Point point_at(const Ray& ray, double across) const;
  int quadrants() const { return manifold_.single_loop() ? 1 : 4; }
  /// A bound on the product of a vector with those of a quadrant (with all, above the bifurcation
  /// value).
  double largest_product(int quadrant, const Vector3<double>& v) const;

 private:
  /// Signs of cos theta and cos eta.
  struct Quadrant {
    double theta, eta;
  };
  /// The half angle of (sqrt(p) sin theta, sqrt(q) sin eta), turned as it is at E^2 in a quadrant;
  /// with sense -1 back.
  Direction turned(const Direction& half, const Quadrant& quadrant, double e2, double sense) const;
  static Quadrant quadrant_of(const Ray& ray) {
    return {ray.quadrant % 2 == 0 ? 1.0 : -1.0, ray.quadrant < 2 ? 1.0 : -1.0};
  }
  Point annulus_point(const Direction& theta, double cosine) const;
  /// From the half angle and E.
  Vector3<double> quadrant_vector(const Quadrant& quadrant, const Direction& half, double e) const;
  /// From the turned half angle and the place between R and the side.
  Point quadrant_point(const Quadrant& quadrant, const Direction& half, double across) const;
  double side(const Direction& half) const;  ///< E^2 where the quadrant ends

  const Manifold& manifold_;
  double p_, q_, c_;
  double least_side_;  ///< least E^2 of a side
  bool small_ovals_;
  double opening_;  ///< R
  Vector3<double> pole_, first_, second_;
};

}  // namespace tensortopo
