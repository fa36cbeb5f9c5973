// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/residual.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "claims/containment.hpp"
#include "curves/conics.hpp"
#include "run/parallel.hpp"

namespace certificate {
namespace {

/// Bounds of a number. Doubles may be rounded a few times.
struct Bounds {
  double low = 0, high = 0;

  static Bounds around(double low, double high) {
    return {low - std::abs(low) * 0x1p-45 - Ball::kTiny, high + std::abs(high) * 0x1p-45 + Ball::kTiny};
  }
  explicit Bounds(const Ball& x) { *this = around(x.value - x.error, x.value + x.error); }
  Bounds(double l, double h) : low(l), high(h) {}
};

Bounds root(const Bounds& x) {
  return Bounds::around(std::sqrt(std::max(x.low, 0.0)), std::sqrt(x.high));
}
/// @pre y.low > 0
Bounds over(const Bounds& x, const Bounds& y) {
  return Bounds::around(x.low < 0 ? x.low / y.low : x.low / y.high,
                       x.high > 0 ? x.high / y.low : x.high / y.high);
}

/// The linear field of a tetrahedron.
class Inside {
 public:
  Inside(const Input& input, const std::array<Vertex, 4>& tet) : origin_(input.points[tet[0]]) {
    double largest = 0, size = 0;
    for (const Vertex v : tet) {
      for (const double x : input.tensors[v]) largest = std::max(largest, std::abs(x));
      for (std::size_t k = 0; k < 3; ++k)
        size = std::max(size, std::abs(input.points[v][k] - origin_[k]));
    }
    if (size > 0) length_ = -std::ilogb(size);
    if (largest > 0) scale_ = std::clamp(-std::ilogb(largest), -1000, 1000);
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<Ball, 6> t;  // XX YY ZZ XY YZ XZ
      for (std::size_t k = 0; k < 6; ++k)
        t[k] = Ball(std::ldexp(input.tensors[tet[i]][k], scale_), Ball::kTiny);
      const Ball trace = t[0] + t[1] + t[2], three(3);
      tensors_[i] = {three * t[0] - trace, three * t[1] - trace, three * t[2] - trace,
                     three * t[4], three * t[5], three * t[3], trace, Ball()};
    }
    for (std::size_t i = 0; i < 3; ++i) edges_[i] = from_origin(input.points[tet[i + 1]]);
    for (std::size_t i = 0; i < 3; ++i)
      normals_[i] = cross(edges_[(i + 1) % 3], edges_[(i + 2) % 3]);
    volume_ = dot(edges_[0], normals_[0]);
  }

  double unit() const { return std::ldexp(1.0, -scale_); }
  const Ball& volume() const { return volume_; }
  /// Three times the deviator and the trace at a place, times six times the volume, in that unit.
  Tensor<Ball> at(const Point3& x) const {
    const Vector3<Ball> d = from_origin(x);
    Ball rest = volume_;
    Tensor<Ball> sum{};
    const auto add = [&](const Ball& weight, const Tensor<Ball>& t) {
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * t[k];
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const Ball weight = dot(normals_[i], d);
      rest -= weight;
      add(weight, tensors_[i + 1]);
    }
    return add(rest, tensors_[0]), sum;
  }

 private:
  Vector3<Ball> from_origin(const Point3& p) const {
    Vector3<Ball> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Ball d = Ball(p[k], 0) - Ball(origin_[k], 0);
      result[k] = Ball(std::ldexp(d.value, length_), std::ldexp(d.error, length_) + Ball::kTiny);
    }
    return result;
  }

  Point3 origin_;
  std::array<Tensor<Ball>, 4> tensors_;
  std::array<Vector3<Ball>, 3> edges_, normals_;
  Ball volume_;
  int length_ = 0, scale_ = 0;
};

/// Of what a level is, and where.
class Quantity {
 public:
  explicit Quantity(const Json& claims) {
    if (claims.contains("mode")) {
      value_ = mode_of(claims["mode"]).get_d();
    } else {
      invariant_ = invariant_of(claims["invariant"]);
      value_ = value_of(claims["value"], *invariant_).get_d();
    }
  }

  /// A bound of the difference at a place.
  double at(const Inside& inside, const Point3& x) const {
    const Tensor<Ball> m = inside.at(x);
    const Forms<Ball, 1> forms({&m});
    const Bounds p(forms.p.coefficients[0]), q(forms.q.coefficients[0]);
    Bounds volume(inside.volume());
    const bool is_turned = volume.high < 0;
    if (is_turned) volume = {-volume.high, -volume.low};
    const double none = invariant_ ? HUGE_VAL : 2;
    if (!(volume.low > 0)) return none;
    if (!invariant_) {
      const Bounds size = Bounds::around(p.low * std::sqrt(std::max(p.low, 0.0)),
                                       p.high * std::sqrt(p.high));
      if (!(size.low > 0)) return none;
      const Bounds mode = over(q, size);
      const double factor = is_turned ? -std::sqrt(54) : std::sqrt(54);  // odd in the tensor
      return std::min(none, farther(factor * mode.low, factor * mode.high));
    }
    const Bounds all(forms.p.coefficients[0] + Ball(3) * m[6] * m[6]);  // 9 |T|^2
    if (*invariant_ == Invariant::anisotropy) {
      if (!(all.low > 0)) return none;
      const Bounds found = root(over(p, all));
      return farther(found.low, found.high);
    }
    const Bounds found = over(root(*invariant_ == Invariant::magnitude ? all : p), volume);
    return farther(found.low / 3 * inside.unit(), found.high / 3 * inside.unit());
  }

 private:
  /// The farther of two numbers from the value, and what rounding may add. NaN: infinite.
  double farther(double a, double b) const {
    const double by = std::max(std::abs(a - value_), std::abs(b - value_));
    const double bound = by + 0x1p-40 * by + (std::abs(a) + std::abs(b) + std::abs(value_)) * 0x1p-50;
    return bound < HUGE_VAL ? bound : HUGE_VAL;
  }

  std::optional<Invariant> invariant_;  ///< nothing: the mode
  double value_ = 0;                    ///< about
};

}  // namespace

double residual_bound(const LevelCase& c, const PlacedSurface& placed) {
  const Quantity quantity(c.claims);
  const auto has_value = [&](std::size_t v) {
    const Carrier& carrier = placed.carriers[v];
    for (std::size_t i = 0; i < carrier.count; ++i)
      if (!c.field.is_zero(carrier.corners[i])) return true;
    return false;
  };
  std::vector<double> bounds(placed.tets.size());
  parallel_for(bounds.size(), [&](std::size_t t) {
    const Inside inside(c.input, c.input.tets[placed.tets[t]]);
    for (const std::uint32_t v : c.surface.triangles[c.triangles.first + t])
      if (has_value(v - c.vertices.first))
        bounds[t] = std::max(bounds[t], quantity.at(inside, c.surface.points[v]));
  });
  return bounds.empty() ? 0 : *std::max_element(bounds.begin(), bounds.end());
}

}  // namespace certificate
