// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/loop_arcs.hpp"

#include <cstddef>
#include <vector>

#include "topology/boundary_weights.hpp"

namespace tensortopo::theory {
namespace {

// A function of one variable and its derivative, over an interval of it.
struct Jet {
  Interval value, slope{0};

  Jet() = default;
  explicit Jet(const Interval& constant) : value(constant) {}
  Jet(const Interval& v, const Interval& d) : value(v), slope(d) {}

  friend Jet operator+(const Jet& p, const Jet& q) {
    return {p.value + q.value, p.slope + q.slope};
  }
  friend Jet operator-(const Jet& p, const Jet& q) {
    return {p.value - q.value, p.slope - q.slope};
  }
  friend Jet operator*(const Jet& p, const Jet& q) {
    return {p.value * q.value, p.value * q.slope + p.slope * q.value};
  }
};

// Requires values above 0.
Jet positive_root(const Jet& p) {
  const Interval r = CGAL::sqrt(p.value);
  return {r, p.slope / (Interval(2) * r)};
}

enum class LoopPlace { inside, outside, passing, unknown };

struct LoopPart {
  LoopPlace place = LoopPlace::unknown;
  std::size_t weight = 0;  ///< if passing
  Verdict slope = Verdict::unknown;

  friend bool operator==(const LoopPart&, const LoopPart&) = default;
};

// Half of the loop: u from -1 to 1 for cos = sign (1 - u^2) / (1 + u^2), sin = sign 2 u / (1 +
// u^2).
LoopPart part_of(const BoundaryLoop& loop, const Interval& u, int sign) {
  const Interval one(1), two(2);
  const Interval length = one + u * u, square = length * length;
  const Interval signed_one(sign);
  const Jet cosine(signed_one * (two / length - one), signed_one * (-two * two * u / square)),
      sine(signed_one * two * u / length, signed_one * two * (two - length) / square);
  const Interval half = (loop.high - loop.low) / two;
  const Jet alpha = Jet((loop.high + loop.low) / two) + Jet(half) * cosine;
  std::array<Jet, 3> m = squares_at(loop, alpha);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}})
    if (certified_sign(m[i].value) != Verdict::positive) return {};
  // (1 - s) alpha + 2 l2 and (1 + s) alpha + 2 l2 vanish at the ends of the interval of alpha.
  const auto& l = loop.l;
  const Interval medium =
      (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]) / two - Interval(3) * l[1] * l[1];
  const Interval height = (one - loop.s * loop.s) * half * half / (Interval(4) * medium);
  if (certified_sign(height) != Verdict::positive) return {};
  const Jet y = Jet(CGAL::sqrt(height)) * sine;
  m[1] = y * y;
  const auto weights = weights_of(
      loop, alpha, m, {positive_root(m[0]), y, Jet(Interval(loop.side)) * positive_root(m[2])});
  LoopPart part;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Verdict sign_of_weight = certified_sign(weights[i].value);
    if (sign_of_weight == Verdict::positive) return {LoopPlace::outside};
    if (sign_of_weight == Verdict::negative)
      ++inside;
    else
      part.weight = i;
  }
  if (inside == 4) return {LoopPlace::inside};
  part.slope = certified_sign(weights[part.weight].slope);
  if (inside == 3 && (part.slope == Verdict::positive || part.slope == Verdict::negative))
    part.place = LoopPlace::passing;
  return part;
}

constexpr std::size_t kMostParts = 20000;

// In order along the loop; nothing if some part stays unknown.
std::optional<std::vector<LoopPart>> parts_of(const BoundaryLoop& loop) {
  std::vector<LoopPart> parts;
  std::size_t tried = 0;
  for (const int sign : {1, -1}) {
    std::vector<Interval> waiting = {Interval(-1, 1)};
    while (!waiting.empty()) {
      if (++tried > kMostParts) return std::nullopt;
      const Interval u = waiting.back();
      waiting.pop_back();
      const LoopPart part = part_of(loop, u, sign);
      if (part.place == LoopPlace::unknown) {
        const double middle = (u.inf() + u.sup()) / 2;
        waiting.emplace_back(middle, u.sup());
        waiting.emplace_back(u.inf(), middle);
      } else if (parts.empty() || parts.back() != part) {
        parts.push_back(part);
      }
    }
  }
  return parts;
}

}  // namespace

std::optional<int> arcs_of_loop(const std::array<Rational, 3>& values, const Rational& s,
                                const std::array<Tensor, 4>& vertices, int side) {
  if (!has_two_loops(values, s)) return std::nullopt;
  const auto parts = parts_of(boundary_loop(values, s, vertices, side));
  if (!parts) return std::nullopt;
  std::size_t first = 0;
  while (first < parts->size() && (*parts)[first].place == LoopPlace::passing) ++first;
  if (first == parts->size()) return std::nullopt;
  int changes = 0;
  LoopPlace last = (*parts)[first].place;
  const auto come_to = [&](LoopPlace place) {
    changes += place != last ? 1 : 0;
    last = place;
  };
  for (std::size_t i = 1; i <= parts->size(); ++i) {
    const LoopPart &before = (*parts)[(first + i - 1) % parts->size()],
                   &part = (*parts)[(first + i) % parts->size()];
    if (part.place != LoopPlace::passing) {
      come_to(part.place);
    } else if (before.place == LoopPlace::passing && before != part) {
      // Where parts of different weights meet, all weights are those of a tensor inside.
      if (before.weight == part.weight) return std::nullopt;
      come_to(LoopPlace::inside);
    }
  }
  return changes / 2;
}

}  // namespace tensortopo::theory
