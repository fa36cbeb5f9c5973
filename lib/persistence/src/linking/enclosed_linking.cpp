// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "tensortopo/persistence/certified_linking.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"
#include "tensortopo/scalar/interval.hpp"

namespace tensortopo {
namespace {

using Point = Vector3<Interval>;

/// A direction of projection, (shear[0], shear[1], 1).
using Shear = std::array<double, 2>;

/// A vertex, and where the projection takes it.
struct Vertex {
  Point place;
  Interval u, w;
};

std::vector<Vertex> projected(std::span<const PlaceBox> boxes, const Shear& shear) {
  std::vector<Vertex> result;
  for (const PlaceBox& box : boxes) {
    const Point p{{box.low.x, box.high.x}, {box.low.y, box.high.y}, {box.low.z, box.high.z}};
    result.push_back({p, p.x - Interval(shear[0]) * p.z, p.y - Interval(shear[1]) * p.z});
  }
  return result;
}

/// Which side of the line through p and q a point is on, as projected: 1, -1, or 0 if not proved.
int side(const Vertex& p, const Vertex& q, const Vertex& r) {
  const Verdict sign = certified_sign((q.u - p.u) * (r.w - p.w) - (q.w - p.w) * (r.u - p.u));
  return sign == Verdict::positive ? 1 : sign == Verdict::negative ? -1 : 0;
}

/// Bounds of a segment as projected.
struct Shadow {
  Shadow(const Vertex& p, const Vertex& q)
      : low{std::min(p.u.inf(), q.u.inf()), std::min(p.w.inf(), q.w.inf())},
        high{std::max(p.u.sup(), q.u.sup()), std::max(p.w.sup(), q.w.sup())} {}
  bool meets(const Shadow& other) const {
    for (std::size_t i = 0; i < 2; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    return true;
  }
  std::array<double, 2> low, high;
};

std::vector<Shadow> shadows_of(const std::vector<Vertex>& vertices) {
  std::vector<Shadow> result;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    result.emplace_back(vertices[i], vertices[(i + 1) % vertices.size()]);
  return result;
}

/// The sign of a crossing of two segments in the projection; 0 if they do not cross there, nothing
/// if that is not proved.
std::optional<int> crossing(const Vertex& p, const Vertex& q, const Vertex& r, const Vertex& s) {
  const int first = side(p, q, r), second = side(p, q, s);
  if (first * second > 0) return 0;
  const int third = side(r, s, p), fourth = side(r, s, q);
  if (third * fourth > 0) return 0;
  if (first * second == 0 || third * fourth == 0) return std::nullopt;
  const Verdict sign =
      certified_sign(dot(cross(q.place - p.place, s.place - r.place), p.place - r.place));
  if (sign == Verdict::positive) return 1;
  if (sign == Verdict::negative) return -1;
  return std::nullopt;
}

std::optional<int> number_in(std::span<const PlaceBox> a, std::span<const PlaceBox> b,
                             const Shear& shear) {
  const auto first = projected(a, shear), second = projected(b, shear);
  const auto first_shadows = shadows_of(first), second_shadows = shadows_of(second);
  int sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      if (!first_shadows[i].meets(second_shadows[j])) continue;
      const auto sign = crossing(first[i], first[(i + 1) % first.size()], second[j],
                                 second[(j + 1) % second.size()]);
      if (!sign) return std::nullopt;
      sum += *sign;
    }
  return sum / 2;
}

}  // namespace

std::optional<int> enclosed_linking_number(std::span<const PlaceBox> a,
                                           std::span<const PlaceBox> b) {
  const FloatingPointEnvironment environment;
  for (const Shear& shear : {Shear{0.0377, -0.0219}, Shear{-0.2713, 0.1631}, Shear{0.7151, 0.4409},
                             Shear{-0.5193, -0.8377}})
    if (const auto number = number_in(a, b, shear)) return number;
  return std::nullopt;
}

}  // namespace tensortopo
