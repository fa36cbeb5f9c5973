// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/linking_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

using Point = Vector3<Rational>;

Point exact(const Vector3<double>& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

int sign_of(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// A direction of projection, (shear[0], shear[1], 1).
using Shear = std::array<double, 2>;

/// Which side of the line through p and q a point is on, seen along the direction.
int side(const Point& p, const Point& q, const Point& r, const Shear& shear) {
  const auto u = [&](const Point& v) { return Rational(v.x - Rational(shear[0]) * v.z); };
  const auto w = [&](const Point& v) { return Rational(v.y - Rational(shear[1]) * v.z); };
  return sign_of((u(q) - u(p)) * (w(r) - w(p)) - (w(q) - w(p)) * (u(r) - u(p)));
}

Rational triple(const Point& a, const Point& b, const Point& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
         a.z * (b.x * c.y - b.y * c.x);
}

struct Box {
  Box(const Vector3<double>& p, const Vector3<double>& q, const Shear& shear) {
    const auto take = [&](std::size_t i, double x, double y) {
      // Wider than the rounding of what is projected.
      const double margin = 1e-9 * (std::abs(x) + std::abs(y) + std::abs(p.z) + std::abs(q.z));
      low[i] = std::min(x, y) - margin;
      high[i] = std::max(x, y) + margin;
    };
    take(0, p.x - shear[0] * p.z, q.x - shear[0] * q.z);
    take(1, p.y - shear[1] * p.z, q.y - shear[1] * q.z);
  }
  bool meets(const Box& other) const {
    for (std::size_t i = 0; i < 2; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    return true;
  }
  std::array<double, 2> low{}, high{};
};

/// Nothing if the projection is not in general position.
std::optional<int> crossings(std::span<const Vector3<double>> a, std::span<const Vector3<double>> b,
                             const Shear& shear) {
  std::vector<Box> boxes;
  for (std::size_t j = 0; j < b.size(); ++j) boxes.emplace_back(b[j], b[(j + 1) % b.size()], shear);
  int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto &p = a[i], &q = a[(i + 1) % a.size()];
    const Box box(p, q, shear);
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (!box.meets(boxes[j])) continue;
      const Point u = exact(p), v = exact(q), r = exact(b[j]), s = exact(b[(j + 1) % b.size()]);
      const std::array<int, 4> sides{side(u, v, r, shear), side(u, v, s, shear),
                                     side(r, s, u, shear), side(r, s, v, shear)};
      if (std::count(sides.begin(), sides.end(), 0) > 0) {
        // Apart all the same if one segment is strictly on one side of the other's line.
        if (sides[0] * sides[1] > 0 || sides[2] * sides[3] > 0) continue;
        return std::nullopt;
      }
      if (sides[0] == sides[1] || sides[2] == sides[3]) continue;
      const auto minus = [](const Point& x, const Point& y) {
        return Point{x.x - y.x, x.y - y.y, x.z - y.z};
      };
      const int sign = sign_of(triple(minus(v, u), minus(s, r), minus(u, r)));
      if (sign == 0) return std::nullopt;
      sum += sign;
    }
  }
  return sum / 2;
}

}  // namespace

std::optional<int> linking_number(std::span<const Vector3<double>> a,
                                  std::span<const Vector3<double>> b) {
  for (const Shear& shear : {Shear{0.0377, -0.0219}, Shear{-0.2713, 0.1631}, Shear{0.7151, 0.4409}})
    if (const auto sum = crossings(a, b, shear)) return sum;
  return std::nullopt;
}

}  // namespace tensortopo
