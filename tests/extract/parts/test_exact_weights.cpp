// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/exact_weights.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {
namespace {

using Weights = ExactWeights<4>;

std::optional<Weights> combination(std::int64_t a, const Weights& u, std::int64_t b,
                                   const Weights& v) {
  return Weights::combination(std::array{a, b}, std::array{u, v});
}

// A place reached from the corners by a chain of cuts, as far as 104 bits go.
Weights random_place() {
  std::vector<Weights> places;
  for (std::size_t i = 0; i < 4; ++i) places.push_back(Weights::at_corner(i));
  for (int step = *rc::gen::inRange(0, 60); step > 0; --step) {
    const auto &u = places[*rc::gen::inRange<std::size_t>(0, places.size())],
               &v = places[*rc::gen::inRange<std::size_t>(0, places.size())];
    const int share = *rc::gen::inRange(1, 32);
    if (const auto m = combination(share, u, 32 - share, v))
      places.push_back(m->scaled(*rc::gen::inRange(-3, 4)));
  }
  return places.back();
}

Rational coordinate(const Weights& w, std::size_t i) {
  const auto place = w.values();
  return Rational(place.high[i]) + Rational(place.low[i]);
}

RC_GTEST_PROP(ExactWeights, CombinationsAreExact, ()) {
  const auto u = random_place(), v = random_place();
  const int a = *rc::gen::inRange(1, 32), b = *rc::gen::inRange(1, 32);
  const auto m = combination(a, u, b, v);
  RC_PRE(m.has_value());
  for (std::size_t i = 0; i < 4; ++i)
    RC_ASSERT(coordinate(*m, i) == a * coordinate(u, i) + b * coordinate(v, i));
}

RC_GTEST_PROP(ExactWeights, CombinationsOfFourAreExact, ()) {
  const std::array places{random_place(), random_place(), random_place(), random_place()};
  std::array<std::int64_t, 4> factors;
  for (auto& factor : factors) factor = *rc::gen::inRange<std::int64_t>(0, 1 << 20);
  const auto m = Weights::combination(factors, places);
  RC_PRE(m.has_value());
  for (std::size_t i = 0; i < 4; ++i) {
    Rational sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += Rational(factors[k]) * coordinate(places[k], i);
    RC_ASSERT(coordinate(*m, i) == sum);
  }
}

RC_GTEST_PROP(ExactWeights, HighPartsAreTheNearestDoubles, ()) {
  const auto w = random_place().values();
  for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(w.high[i] + w.low[i] == w.high[i]);
}

// What is refused has a coordinate that does not fit in 104 bits beside the others.
RC_GTEST_PROP(ExactWeights, OnlyLongCombinationsAreRefused, ()) {
  const auto u = random_place(), v = random_place();
  const auto m = combination(1, u, 1, v);
  Rational largest = 0, smallest = 0;  // smallest: lowest set bit
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational sum = coordinate(u, i) + coordinate(v, i);
    if (sum == 0) continue;
    if (sum > largest) largest = sum;
    Rational bit = 1;
    while (denominator(Rational(sum / bit)) != 1) bit /= 2;
    while (denominator(Rational(sum / (2 * bit))) == 1) bit *= 2;
    if (smallest == 0 || bit < smallest) smallest = bit;
  }
  const Rational all_bits = Rational(std::int64_t{1} << 52) * Rational(std::int64_t{1} << 52);
  const bool fits = largest / smallest < all_bits;
  if (m) {
    RC_ASSERT(fits);
  } else {
    RC_ASSERT(largest / smallest * 1024 > all_bits);
  }
}

RC_GTEST_PROP(ExactWeights, OrderAlongAnEdgeIsThatOfTheRatio, ()) {
  const auto on_edge = [] {
    const int a = *rc::gen::inRange(0, 4000), b = *rc::gen::inRange(1, 4000);
    auto place = *combination(a, Weights::at_corner(1), b, Weights::at_corner(3));
    return place.scaled(*rc::gen::inRange(-3, 4));
  };
  const auto u = on_edge(), v = on_edge();
  const auto place = [](const Weights& w) -> Rational {
    return coordinate(w, 3) / (coordinate(w, 1) + coordinate(w, 3));
  };
  RC_ASSERT(u.comes_before(v, 1, 3) == (place(u) < place(v)));
  RC_ASSERT(u.comes_before(v, 3, 1) == (place(v) < place(u)));
}

}  // namespace
}  // namespace tensortopo::test
