// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interval_lines.hpp"

namespace tensortopo::detail {

/// Where a polynomial may vanish.
struct IntervalRoot {
  Range x;
  bool is_certain = false;  ///< exactly one zero, a simple one, and inside the range asked about
  int slope = 0;            ///< sign of the derivative, if certain
};

/// Shrinks x to where Newton's operator lets zeros be.
inline IntervalRoot newton(const Polynomial& p, Range x) {
  const Polynomial dp = derivative(p);
  IntervalRoot root{x};
  for (int step = 0; step < 60; ++step) {
    const Range slope = range_of(dp, x);
    if (!is_not_zero(slope)) return root;
    const Range m(middle(x)), image = m - horner(p, m) / slope;
    if (image.inf() > x.inf() && image.sup() < x.sup()) root.is_certain = true;
    root.slope = slope.inf() > 0 ? 1 : -1;
    const double from = std::max(x.inf(), image.inf()), to = std::min(x.sup(), image.sup());
    if (!(from <= to)) return root;
    const bool gained = to - from < 0.7 * (x.sup() - x.inf());
    x = root.x = Range(from, to);
    if (!gained) break;
  }
  return root;
}

/// Ranges that hold all zeros of a polynomial in [low, high], disjoint and ascending. Parts may be
/// refused beforehand: `skip(x)` says that zeros in x are of no interest.
/// Requires `UpwardRounding`.
template <class Skip>
std::vector<IntervalRoot> interval_roots(const Polynomial& p, double low, double high,
                                         const Skip& skip) {
  // Not halves: zeros at dyadic places should not fall between two parts.
  constexpr double kCut = 0.4853;
  constexpr int kLastDepth = 52, kMostParts = 3000;
  const Polynomial dp = derivative(p);
  struct Part {
    double from, to;
    int depth;
    bool has_one = false;  ///< proved: the signs at the ends differ, and the slope has one sign
  };
  std::vector<Part> parts{{low, high, 0}}, left;
  for (int looked = 0; !parts.empty(); ++looked) {
    const Part part = parts.back();
    parts.pop_back();
    const Range x(part.from, part.to);
    if (is_not_zero(range_of(p, x)) || skip(x)) continue;
    const double cut = part.from + kCut * (part.to - part.from);
    const bool is_last =
        part.depth >= kLastDepth || looked > kMostParts || !(cut > part.from) || !(cut < part.to);
    if (is_not_zero(range_of(dp, x))) {
      const Range a = horner(p, Range(part.from)), b = horner(p, Range(part.to));
      const bool opposite = (a.sup() < 0 && b.inf() > 0) || (a.inf() > 0 && b.sup() < 0);
      if (is_not_zero(a) && is_not_zero(b)) {
        if (opposite) left.push_back({part.from, part.to, part.depth, true});
        continue;
      }
    }
    if (is_last) {
      left.push_back(part);
      continue;
    }
    parts.push_back({cut, part.to, part.depth + 1});
    parts.push_back({part.from, cut, part.depth + 1});
  }
  // They come in ascending order. Parts that touch and are not settled may share a zero.
  std::vector<IntervalRoot> roots;
  for (std::size_t i = 0, next; i < left.size(); i = next) {
    double from = left[i].from, to = left[i].to;
    next = i + 1;
    if (left[i].has_one) {
      roots.push_back(newton(p, Range(from, to)));
      roots.back().is_certain = true;
      continue;
    }
    while (next < left.size() && !left[next].has_one && left[next].from <= to) to = left[next++].to;
    const double margin = std::max(2 * (to - from), 0x1p-33);
    const IntervalRoot root = newton(p, Range(from - margin, to + margin));
    const bool is_inside = root.x.inf() > low && root.x.sup() < high;
    const bool is_apart = (i == 0 || left[i - 1].to < root.x.inf()) &&
                          (next == left.size() || left[next].from > root.x.sup());
    // The margin may have let in another zero, and is no part of what was asked about.
    if (root.is_certain && is_inside && is_apart)
      roots.push_back(root);
    else
      roots.push_back(IntervalRoot{Range(from, to)});
  }
  return roots;
}

}  // namespace tensortopo::detail
