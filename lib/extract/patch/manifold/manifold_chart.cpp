// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/manifold/manifold_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

/// Keeps a division finite; no region reaches a pole or a whole meridian of the complex domain.
constexpr double kTiny = std::numeric_limits<double>::min();

/// Up to this share of E^2 at the side of a quadrant an oval counts as small.
constexpr double kSmallShare = 1.0 / 64;

double root(double x) { return std::sqrt(std::max(0.0, x)); }

ManifoldChart::Direction direction(double angle) {
  return {elementary::cos(angle), elementary::sin(angle)};
}

}  // namespace

ManifoldChart::ManifoldChart(const Manifold& manifold)
    : manifold_(manifold),
      p_(manifold.p()),
      q_(manifold.q()),
      c_(manifold.c()),
      least_side_(std::min(p_, q_)),
      small_ovals_(c_ < kSmallShare * least_side_),
      opening_(small_ovals_ ? std::max(root(c_), 0.4 * root(least_side_)) : root(c_)),
      pole_(manifold.sphere_point(0, 0)) {
  first_ = manifold.characteristic().eigenvectors[1];
  second_ = cross(pole_, first_);
}

double ManifoldChart::side(const Direction& d) const {
  return std::min(d.cosine != 0 ? p_ / (d.cosine * d.cosine) : 1e300,
                  d.sine != 0 ? q_ / (d.sine * d.sine) : 1e300);
}

ManifoldChart::Direction ManifoldChart::turned(const Direction& d, const Quadrant& quadrant,
                                               double e2, double sense) const {
  if (!small_ovals_ || !(e2 < least_side_)) return d;
  const double angle =
      elementary::asin(e2 > c_ ? c_ / e2 : 1.0) - elementary::asin(std::min(1.0, c_ / least_side_));
  const Direction by = direction(-0.5 * sense * quadrant.theta * quadrant.eta * angle);
  return {d.cosine * by.cosine - d.sine * by.sine, d.sine * by.cosine + d.cosine * by.sine};
}

ManifoldChart::Point ManifoldChart::annulus_point(const Direction& theta, double cosine) const {
  const double radius =
      elementary::exp(elementary::acos(std::clamp(cosine, -1.0, 1.0)) - std::numbers::pi / 2);
  return {radius * theta.cosine, radius * theta.sine};
}

Vector3<double> ManifoldChart::quadrant_vector(const Quadrant& quadrant, const Direction& d,
                                               double e) const {
  const double sin_theta = p_ > 0 ? std::clamp(e * d.cosine / std::sqrt(p_), -1.0, 1.0) : 0;
  const double sin_eta = std::clamp(e * d.sine / std::sqrt(q_), -1.0, 1.0);
  // Half angles outside of [0, pi] go on across the cut eta = 0, which has two names.
  const double flip = sin_eta < 0 ? -1 : 1;
  return manifold_.sphere_point({flip * sin_theta, quadrant.theta * root(1 - sin_theta * sin_theta),
                                 flip * sin_eta, quadrant.eta * root(1 - sin_eta * sin_eta)});
}

ManifoldChart::Point ManifoldChart::quadrant_point(const Quadrant& quadrant, const Direction& d,
                                                   double across) const {
  const auto w = quadrant_vector(quadrant, d, opening_ + (std::sqrt(side(d)) - opening_) * across);
  const double height = std::max(kTiny, 1 - dot(w, pole_));
  return {dot(w, first_) / height, dot(w, second_) / height};
}

ManifoldChart::Point ManifoldChart::operator()(const Vector3<double>& v) const {
  const auto [sin_theta, cos_theta, sin_eta, cos_eta] = manifold_.sphero_conal_sines(v);
  if (manifold_.single_loop()) {
    const double sin2_boundary = std::max(0.0, (c_ - p_ * sin_theta * sin_theta) / q_);
    return annulus_point({cos_theta, sin_theta},
                         cos_eta / std::sqrt(std::max(kTiny, 1 - sin2_boundary)));
  }
  const Quadrant quadrant{std::copysign(1.0, cos_theta), std::copysign(1.0, cos_eta)};
  const double x = std::sqrt(p_) * sin_theta, y = std::sqrt(q_) * sin_eta;
  const double e2 = x * x + y * y, e = std::sqrt(e2);
  const Direction half = turned(e > 0 ? Direction{x / e, y / e} : Direction{1, 0}, quadrant, e2, 1);
  const double s = side(half);
  const double range = small_ovals_ ? (s - c_) * (s + c_) : s - c_;
  const double superlevel = small_ovals_ ? (e2 - c_) * (e2 + c_) : e2 - c_;
  const double across = range > 0 ? root(superlevel / range) : 1;
  return quadrant_point(quadrant, half, std::min(across, 1.0));
}

ManifoldChart::Point ManifoldChart::at_boundary(const BoundaryPosition<double>& at) const {
  const double sign = at.sign;
  if (manifold_.single_loop()) return (*this)(sign * manifold_.boundary_point(at.loop, at.phi));
  const Quadrant quadrant{at.loop == 0 ? sign : -sign, sign};
  const double half_angle = quadrant.theta > 0 ? at.phi / 2 : std::numbers::pi - at.phi / 2;
  return quadrant_point(quadrant, turned(direction(half_angle), quadrant, c_, 1), 0);
}

ManifoldChart::Ray ManifoldChart::ray(int quadrant, double around) const {
  const double angle = (manifold_.single_loop() ? 2 : 1) * std::numbers::pi * around;
  const Direction d = direction(angle);
  const double end =
      manifold_.single_loop() ? root(1 - std::max(0.0, (c_ - p_ * d.sine * d.sine) / q_)) : side(d);
  return {quadrant, d, end};
}

double ManifoldChart::largest_product(int quadrant, const Vector3<double>& v) const {
  const auto& [e1, e2, e3] = manifold_.characteristic().eigenvectors;
  double x = dot(v, e1), z = dot(v, e3);
  const double y = dot(v, e2);
  if (quadrants() > 1) {
    // The signs of cos theta and cos eta are those of the first and last coordinate.
    const Quadrant q = quadrant_of({quadrant, {}, 0});
    x = std::max(0.0, q.theta * x), z = std::max(0.0, q.eta * z);
  }
  return std::sqrt(x * x + y * y + z * z);
}

Vector3<double> ManifoldChart::vector_at(const Ray& ray, double across) const {
  if (manifold_.single_loop()) {
    const double cos_eta = elementary::cos(std::numbers::pi * across) * ray.end;
    return manifold_.sphere_point(
        {ray.at.sine, ray.at.cosine, root(1 - cos_eta * cos_eta), cos_eta});
  }
  const Quadrant q = quadrant_of(ray);
  const double s = ray.end;
  const double e2 = small_ovals_ ? std::sqrt(c_ * c_ + across * across * (s - c_) * (s + c_))
                                 : c_ + across * across * (s - c_);
  return quadrant_vector(q, turned(ray.at, q, e2, -1), std::sqrt(e2));
}

ManifoldChart::Point ManifoldChart::point_at(const Ray& ray, double across) const {
  if (manifold_.single_loop())
    return annulus_point(ray.at, elementary::cos(std::numbers::pi * across));
  return quadrant_point(quadrant_of(ray), ray.at, across);
}

}  // namespace tensortopo
