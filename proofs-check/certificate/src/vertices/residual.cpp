// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertices/residual.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "run/parallel.hpp"
#include "vertices/linear_field.hpp"

namespace certificate {
namespace {

/// Bounds of a number. Doubles may be rounded a few times.
struct Bounds {
  double low = 0, high = 0;

  static Bounds around(double low, double high) {
    return {low - std::abs(low) * 0x1p-45 - Ball::kTiny,
            high + std::abs(high) * 0x1p-45 + Ball::kTiny};
  }
  explicit Bounds(const Ball& x) { *this = around(x.value - x.error, x.value + x.error); }
  Bounds(double l, double h) : low(l), high(h) {}
};

Bounds square_root(const Bounds& x) {
  return Bounds::around(std::sqrt(std::max(x.low, 0.0)), std::sqrt(x.high));
}
/// @pre y.low > 0
Bounds over(const Bounds& x, const Bounds& y) {
  return Bounds::around(x.low < 0 ? x.low / y.low : x.low / y.high,
                        x.high > 0 ? x.high / y.low : x.high / y.high);
}

/// Of what a level is, and where.
class Quantity {
 public:
  explicit Quantity(double mode) : value_(mode) {}
  Quantity(Invariant invariant, double value) : invariant_(invariant), value_(value) {}

  /// A bound of the difference at a place.
  double at(const LinearField& inside, const Point3& x) const {
    const Tensor<Ball> m = inside.at(x);
    const Forms<Ball, 1> forms({&m});
    const Bounds p(forms.p.coefficients[0]), q(forms.q.coefficients[0]);
    Bounds volume(inside.volume());
    const bool is_turned = volume.high < 0;
    if (is_turned) volume = {-volume.high, -volume.low};
    const double none = invariant_ ? HUGE_VAL : 2;
    if (!(volume.low > 0)) return none;
    if (!invariant_) {
      const Bounds size =
          Bounds::around(p.low * std::sqrt(std::max(p.low, 0.0)), p.high * std::sqrt(p.high));
      if (!(size.low > 0)) return none;
      const Bounds mode = over(q, size);
      const double factor = is_turned ? -std::sqrt(54) : std::sqrt(54);  // odd in the tensor
      return std::min(none, farther(factor * mode.low, factor * mode.high));
    }
    const Bounds all(forms.p.coefficients[0] + Ball(3) * m[6] * m[6]);  // 9 |T|^2
    if (*invariant_ == Invariant::anisotropy) {
      if (!(all.low > 0)) return none;
      const Bounds found = square_root(over(p, all));
      return farther(found.low, found.high);
    }
    const Bounds found = over(square_root(*invariant_ == Invariant::magnitude ? all : p), volume);
    return farther(found.low / 3 * inside.unit(), found.high / 3 * inside.unit());
  }

 private:
  /// The farther of two numbers from the value, and what rounding may add. NaN: infinite.
  double farther(double a, double b) const {
    const double by = std::max(std::abs(a - value_), std::abs(b - value_));
    const double bound =
        by + 0x1p-40 * by + (std::abs(a) + std::abs(b) + std::abs(value_)) * 0x1p-50;
    return bound < HUGE_VAL ? bound : HUGE_VAL;
  }

  std::optional<Invariant> invariant_;  ///< nothing: the mode
  double value_;                        ///< about
};

Quantity quantity_of(const Json& claims) {
  if (claims.contains("mode")) return Quantity(mode_of(claims["mode"]).get_d());
  const Invariant invariant = invariant_of(claims["invariant"]);
  return {invariant, value_of(claims["value"], invariant).get_d()};
}

double largest(const std::vector<double>& bounds) {
  return bounds.empty() ? 0 : *std::max_element(bounds.begin(), bounds.end());
}

}  // namespace

double residual_bound(const LevelCase& c, const PlacedSurface& placed) {
  const Quantity quantity = quantity_of(c.claims);
  std::vector<double> bounds(placed.tets.size());
  parallel_for(bounds.size(), [&](std::size_t t) {
    const LinearField inside(c.input, c.input.tets[placed.tets[t]]);
    for (const std::uint32_t v : c.surface.triangles[c.triangles.first + t])
      if (!is_apex(c, placed.carriers[v - c.vertices.first]))
        bounds[t] = std::max(bounds[t], quantity.at(inside, c.surface.points[v]));
  });
  return largest(bounds);
}

double residual_bound(const CurveCase& c) {
  const Quantity quantity(kind_of(c.claims["mode"]) == Kind::linear ? 1 : -1);
  std::vector<double> bounds(c.lines.count);
  parallel_for(bounds.size(), [&](std::size_t l) {
    const std::size_t tet = c.input.tet_at(c.curves.cells[c.lines.first + l]);
    if (tet == Input::kNone || c.left_out[tet]) return;
    const LinearField inside(c.input, c.input.tets[tet]);
    for (const std::uint32_t v : c.curves.lines[c.lines.first + l])
      bounds[l] = std::max(bounds[l], quantity.at(inside, c.curves.points[v]));
  });
  return largest(bounds);
}

}  // namespace certificate
