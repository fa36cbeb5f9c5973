// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

/// A number with the running bound on its error, in roundings of size one (to first order).
struct Running {
  double value = 0, error = 0;

  Running() = default;
  explicit Running(double v) : value(v) {}
  Running(double v, double e) : value(v), error(e) {}
  friend Running operator+(const Running& p, const Running& q) {
    const double v = p.value + q.value;
    return {v, p.error + q.error + std::abs(v)};
  }
  friend Running operator-(const Running& p) { return {-p.value, p.error}; }
  friend Running operator-(const Running& p, const Running& q) { return p + -q; }
  friend Running operator/(const Running& p, const Running& q) {
    const double v = p.value / q.value;
    return {v, (p.error + std::abs(v) * q.error) / std::abs(q.value) + std::abs(v)};
  }
  friend Running operator*(const Running& p, const Running& q) {
    const double v = p.value * q.value;
    return {v, std::abs(p.value) * q.error + std::abs(q.value) * p.error + std::abs(v)};
  }
  Running& operator+=(const Running& q) { return *this = *this + q; }
};

/// How many roundings the terms of a number have passed through, at most. What is zero, or a power
/// of two times something, is not rounded.
struct Roundings {
  double value = 0;
  int count = 0;

  Roundings() = default;
  explicit Roundings(double v) : value(v) {}
  Roundings(double v, int n) : value(v), count(n) {}
  bool is_exact(double v) const { return count == 0 && value == v; }
  bool is_power_of_two() const {
    int exponent = 0;
    return count == 0 && std::abs(std::frexp(value, &exponent)) == 0.5;
  }
  friend Roundings operator+(const Roundings& p, const Roundings& q) {
    if (p.is_exact(0)) return q;
    if (q.is_exact(0)) return p;
    return {p.value + q.value, std::max(p.count, q.count) + 1};
  }
  friend Roundings operator-(const Roundings& p) { return {-p.value, p.count}; }
  friend Roundings operator-(const Roundings& p, const Roundings& q) { return p + -q; }
  friend Roundings operator*(const Roundings& p, const Roundings& q) {
    if (p.is_exact(0) || q.is_exact(0)) return {};
    if (p.is_power_of_two() || q.is_power_of_two()) return {p.value * q.value, p.count + q.count};
    return {p.value * q.value, p.count + q.count + 1};
  }
  friend Roundings operator/(const Roundings& p, const Roundings& q) {
    if (q.is_power_of_two()) return {p.value / q.value, p.count};
    return {p.value / q.value, p.count + q.count + 1};
  }
  Roundings& operator+=(const Roundings& q) { return *this = *this + q; }
  friend bool operator>(const Roundings& p, const Roundings& q) { return p.value > q.value; }
};

}  // namespace
}  // namespace tensortopo::test

template <>
struct tensortopo::ScalarTraits<tensortopo::test::Roundings> {
  static constexpr bool is_exact = false;
  static constexpr bool has_roots = false;
  static constexpr bool is_enclosure = false;
};

template <>
struct tensortopo::ScalarTraits<tensortopo::test::Running> {
  static constexpr bool is_exact = false;
  static constexpr bool has_roots = false;
  static constexpr bool is_enclosure = false;
};

namespace tensortopo::test {
namespace {

/// Parameters of a case: five numbers a tensor, then a direction.
template <std::size_t Vertices>
using Parameters = std::array<double, 6 * Vertices>;

/// Largest error of a Bernstein coefficient.
template <class Polynomial>
double largest_error(const Polynomial& p) {
  double largest = 0;
  for (std::size_t i = 0; i < p.size; ++i)
    largest = std::max(largest, p.coefficients[i].error / p.multinomials[i]);
  return largest;
}

/// Linear bounds on the norm, further apart than most.
template <std::size_t Vertices>
NormBounds<Running, Vertices> wide_bounds() {
  NormBounds<Running, Vertices> bounds;
  bounds.upper.fill(Running(1));
  bounds.lower = Running(0.25);
  return bounds;
}

bool operator>(const Running& p, const Running& q) { return p.value > q.value; }

Level<Running> strict_level() {
  Level<Running> level;
  level.sqrt2 = Running(std::sqrt(2.0), std::sqrt(2.0));
  level.mu = Running(1, 1);
  return level;
}

/// Of the cubics of increase.
template <std::size_t Vertices>
double largest_error(const ModeForms<Running, Vertices>& forms,
                     const std::array<Running, Vertices>& d) {
  using Increase = LevelIncrease<Running, Vertices>;
  const auto coefficients = Increase(forms, wide_bounds<Vertices>(), strict_level())(d);
  double largest = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    largest = std::max(
        largest, coefficients[k].error / Increase::Cubic::multinomials[k % Increase::Cubic::size]);
  return largest;
}

struct Errors {
  double determinant = 0, increase = 0, generalized = 0, side = 0;
};

template <std::size_t Vertices>
Errors errors_of(const Parameters<Vertices>& x) {
  std::array<Deviator<Running>, Vertices> tensors;
  std::array<Running, Vertices> d;
  for (std::size_t i = 0; i < Vertices; ++i) {
    Deviator<double> t{x[6 * i], x[6 * i + 1], x[6 * i + 2], x[6 * i + 3], x[6 * i + 4]};
    const double norm = std::sqrt(norm_form(t));
    tensors[i] = {Running(t.a / norm), Running(t.b / norm), Running(t.xy / norm),
                  Running(t.yz / norm), Running(t.xz / norm)};
    d[i] = Running(std::clamp(x[6 * i + 5], -1.0, 1.0));
  }
  const auto forms = mode_forms(tensors);
  return {largest_error(forms.determinant), largest_error(forms, d),
          largest_error(generalized_mode_form(forms, Running(1))),
          largest_error(side_form(forms, wide_bounds<Vertices>(), strict_level(), false))};
}

/// The largest value that a search finds: random starts, each improved by smaller and smaller
/// random steps.
template <std::size_t Vertices>
double worst(double Errors::*which, std::uint64_t seed) {
  Random random(seed);
  double worst = 0;
  for (int start = 0; start < trials(12); ++start) {
    Parameters<Vertices> x;
    for (auto& p : x) p = random.normal();
    double at = errors_of<Vertices>(x).*which;
    for (int step = 0; step < 400; ++step) {
      auto y = x;
      for (auto& p : y) p += random.normal() * std::exp2(-step / 80.0);
      const double there = errors_of<Vertices>(y).*which;
      if (there > at) at = there, x = y;
    }
    worst = std::max(worst, at);
  }
  return worst;
}

void expect_bounded(double Errors::*which, double constant, const char* name) {
  const std::uint64_t seed = 20241210;
  SCOPED_TRACE(std::string(name) + ", " + announce(seed));
  const double found =
      std::max({worst<2>(which, seed), worst<3>(which, seed), worst<4>(which, seed)});
  std::cout << name << ": errors of up to " << found << " roundings, bound " << constant << '\n';
  EXPECT_LE(found, constant);
  EXPECT_GT(found, constant / 1000);  // else the bound says little, or nothing was tried
}

/// Most roundings in any coefficient.
template <class Numbers>
int most_roundings(const Numbers& numbers) {
  int most = 0;
  for (const Roundings& x : numbers) most = std::max(most, x.count);
  return most;
}

struct Depths {
  int determinant = 0, others = 0;
};

/// Of tensors without zeros, so that no term is missing.
template <std::size_t Vertices>
Depths depths() {
  Random random(7);
  std::array<Deviator<Roundings>, Vertices> tensors;
  std::array<Roundings, Vertices> d;
  NormBounds<Roundings, Vertices> bounds;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto any = [&] { return Roundings(random.normal()); };
    tensors[i] = {any(), any(), any(), any(), any()};
    d[i] = any();
    bounds.upper[i] = Roundings(1.1, 1);
  }
  bounds.lower = Roundings(0.3, 1);
  Level<Roundings> level;
  level.sqrt2 = Roundings(std::sqrt(2.0), 1);
  level.mu = Roundings(0.3, 1);
  const auto forms = mode_forms(tensors);
  return {most_roundings(forms.determinant.coefficients),
          std::max({most_roundings(LevelIncrease<Roundings, Vertices>(forms, bounds, level)(d)),
                    most_roundings(side_form(forms, bounds, level, true).coefficients),
                    most_roundings(side_form(forms, bounds, level, false).coefficients),
                    most_roundings(generalized_mode_form(forms, Roundings(0.3, 1)).coefficients)})};
}

// What is said beside the constants: each is a number of roundings times a sum of moduli.
TEST(ErrorBounds, AreRoundingsTimesSumsOfModuli) {
  const std::array all{depths<2>(), depths<3>(), depths<4>()};
  int determinant = 0, others = 0;
  for (const Depths& d : all) {
    determinant = std::max(determinant, d.determinant);
    others = std::max(others, d.others);
  }
  std::cout << determinant << " roundings of the determinant, " << others << " of other forms\n";
  EXPECT_LE(determinant, 20);
  EXPECT_GE(determinant, 5);
  EXPECT_LE(others, 50);
  EXPECT_GE(others, 15);
  // Of a norm of one: three times a tensor has the norm sqrt(3), a polar adjugate at most twice the
  // product of two. In moduli a^2 + b^2 + (a + b)^2 is at most 3 (a^2 + b^2), and without them at
  // least a^2 + b^2.
  const double adjugate = 2 * std::pow(std::sqrt(3.0), 3), polar = 3, sqrt2 = std::sqrt(2.0);
  EXPECT_GE(detail::kDeterminantBound, 20 * adjugate);
  EXPECT_GE(detail::kIncreaseBound,
            50 * (2 * 3 * (4 * adjugate) + 9 * sqrt2 * 3 * (2 * 4 * polar)));
  EXPECT_GE(detail::kSideBound, 50 * (adjugate + 3 * sqrt2 * polar * polar));
  EXPECT_GE(detail::kGeneralizedBound, 50 * (adjugate * adjugate + 18 * std::pow(polar, 3)));
}

// The constants of the double tier against the running error of the very code that they are about,
// for vertex tensors of norm one.
TEST(ErrorBounds, OfTheDeterminantCoverItsRoundings) {
  expect_bounded(&Errors::determinant, detail::kDeterminantBound, "6 Q");
}

TEST(ErrorBounds, OfTheCubicsOfIncreaseCoverTheirRoundings) {
  expect_bounded(&Errors::increase, detail::kIncreaseBound, "2 l dR - k q dP");
}

TEST(ErrorBounds, OfTheFormOfSidesCoverItsRoundings) {
  expect_bounded(&Errors::side, detail::kSideBound, "l (6 Q - k P q)");
}

TEST(ErrorBounds, OfTheFormOfDegreeSixCoverItsRoundings) {
  expect_bounded(&Errors::generalized, detail::kGeneralizedBound, "degree six");
}

}  // namespace
}  // namespace tensortopo::test
