// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level_sign.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {

namespace {

// s - t as a sum of two doubles without error.
void exact_difference(double s, double t, double& high, double& low) {
  high = s - t;
  const double virtual_t = s - high, virtual_s = high + virtual_t;
  low = (s - virtual_s) + (virtual_t - t);
}

}  // namespace

ExactDeviator::ExactDeviator(const SymmetricTensor<double>& t) {
  exact_difference(t.xx, t.yy, high[0], low[0]);
  exact_difference(t.yy, t.zz, high[1], low[1]);
  high[2] = t.xy, high[3] = t.yz, high[4] = t.xz;
}

ExactDeviator::ExactDeviator(const Deviator<double>& d) : high{d.a, d.b, d.xy, d.yz, d.xz} {}

LevelQuestion::LevelQuestion(std::span<const ExactDeviator> corners, double mode)
    : size_(corners.size()), mode_(mode) {
  if (size_ == 0 || size_ > 4) throw std::invalid_argument("one to four corners");
  if (!(std::abs(mode) < 1)) throw std::invalid_argument("mode strictly between -1 and 1");
  for (std::size_t i = 0; i < size_; ++i) {
    corners_[i] = corners[i];
    for (std::size_t c = 0; c < 5; ++c) {
      rounded_[i][c] = static_cast<long double>(corners[i].high[c]) + corners[i].low[c];
      bound_[i] = std::max(bound_[i], std::abs(rounded_[i][c]));
    }
  }
  signed_square_ = static_cast<long double>(mode) * std::abs(mode);
}

int LevelQuestion::sign(std::span<const std::int64_t> weights) const {
  Five<long double> t{};
  long double bound = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const auto w = static_cast<long double>(weights[i]);
    for (std::size_t c = 0; c < 5; ++c) t[c] += w * rounded_[i][c];
    bound += std::abs(w) * bound_[i];
  }
  const long double p = square_norm(t);
  // Rounding moves each coordinate by less than 2^-60 of `bound`; the mode, squared with its
  // sign, changes by less than twenty times the relative change of the tensor.
  constexpr long double unit = 0x1p-60L, arithmetic = 0x1p-52L;
  if (p > 0) {
    const long double relative = 4 * unit * bound / std::sqrt(p);
    const long double g = level_form(p, cubic_form(t), signed_square_);
    if (std::abs(g) > (arithmetic + 64 * relative) * p * p * p) return g > 0 ? 1 : -1;
  }
  return exact_sign(weights);
}

int LevelQuestion::exact_sign(std::span<const std::int64_t> weights) const {
  Five<Rational> t;
  for (std::size_t c = 0; c < 5; ++c) {
    t[c] = Rational(0);
    for (std::size_t i = 0; i < size_; ++i) {
      t[c] += Rational(weights[i]) * (Rational(corners_[i].high[c]) + Rational(corners_[i].low[c]));
    }
  }
  const Rational m(mode_), signed_square = mode_ < 0 ? Rational(-(m * m)) : Rational(m * m);
  const Rational g = level_form<Rational>(square_norm(t), cubic_form(t), signed_square);
  return g > 0 ? 1 : g < 0 ? -1 : 0;
}

namespace {

// Polynomial of degree `values.size() - 1` through values at 0, 1, -1, 2 (long double; the
// degrees are at most three and the values are of one size, so nothing is lost that matters).
std::array<long double, 4> cubic_through(long double at_0, long double at_1, long double at_minus_1,
                                         long double at_2) {
  const long double even = (at_1 + at_minus_1) / 2 - at_0, odd = (at_1 - at_minus_1) / 2;
  const long double cube = (at_2 - at_0 - 4 * even - 2 * odd) / 6;
  return {at_0, odd - cube, even, cube};
}

long double evaluate(const std::array<long double, 4>& p, long double t) {
  return ((p[3] * t + p[2]) * t + p[1]) * t + p[0];
}

// Points of (0, 1) where a cubic changes sign, in order.
std::vector<long double> sign_changes(const std::array<long double, 4>& p) {
  std::vector<long double> cuts{0};
  const long double a = 3 * p[3], b = p[2], c = p[1];  // the derivative a t^2 + 2 b t + c
  const long double disc = b * b - a * c;
  if (disc >= 0) {
    const long double q = -(b + std::copysign(std::sqrt(disc), b));
    std::array<long double, 2> roots{a != 0 ? q / a : -1, q != 0 ? c / q : -1};
    std::sort(roots.begin(), roots.end());
    for (const long double r : roots) {
      if (r > 0 && r < 1) cuts.push_back(r);
    }
  }
  cuts.push_back(1);
  std::vector<long double> result;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    long double low = cuts[i], high = cuts[i + 1];
    const bool low_sign = evaluate(p, low) > 0;
    if (low_sign == (evaluate(p, high) > 0)) continue;
    for (int step = 0; step < 70; ++step) {
      const long double middle = (low + high) / 2;
      ((evaluate(p, middle) > 0) == low_sign ? low : high) = middle;
    }
    result.push_back(low);
  }
  return result;
}

}  // namespace

int exact_edge_crossings(const LevelQuestion& question, std::size_t i, std::size_t j) {
  const auto at = [&](long double t) {
    Five<long double> value{};
    for (std::size_t c = 0; c < 5; ++c) {
      value[c] = (1 - t) * question.corner(i)[c] + t * question.corner(j)[c];
    }
    return value;
  };
  const auto q =
      cubic_through(cubic_form(at(0)), cubic_form(at(1)), cubic_form(at(-1)), cubic_form(at(2)));
  const auto p = cubic_through(square_norm(at(0)), square_norm(at(1)), square_norm(at(-1)),
                               square_norm(at(2)));
  // 2 P Q' - 3 Q P' with P quadratic: the terms of degree four cancel.
  const std::array<long double, 4> slope{
      2 * p[0] * q[1] - 3 * q[0] * p[1],
      2 * (2 * p[0] * q[2] + p[1] * q[1]) - 3 * (2 * q[0] * p[2] + q[1] * p[1]),
      2 * (3 * p[0] * q[3] + 2 * p[1] * q[2] + p[2] * q[1]) - 3 * (2 * q[1] * p[2] + q[2] * p[1]),
      2 * (3 * p[1] * q[3] + 2 * p[2] * q[2]) - 3 * (2 * q[2] * p[2] + q[3] * p[1])};

  constexpr std::int64_t whole = std::int64_t{1} << 52;
  const auto above = [&](std::int64_t t) {
    std::array<std::int64_t, 4> weights{};
    weights[i] = whole - t, weights[j] = t;
    return question.is_above(weights);
  };
  int crossings = 0;
  bool last = above(0);
  const auto visit = [&](std::int64_t t) {
    const bool next = above(t);
    crossings += next != last;
    last = next;
  };
  for (const long double t : sign_changes(slope)) {
    visit(static_cast<std::int64_t>(std::llround(t * static_cast<long double>(whole))));
  }
  visit(whole);
  return crossings;
}

}  // namespace tensortopo::test
