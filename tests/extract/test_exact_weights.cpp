// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/exact_weights.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {
namespace {

using Weights = ExactWeights<4>;

// A place reached from the corners by a chain of cuts, as far as 52 bits go.
Weights random_place() {
  std::vector<Weights> places;
  for (std::size_t i = 0; i < 4; ++i) places.push_back(Weights::at_corner(i));
  for (int step = *rc::gen::inRange(0, 30); step > 0; --step) {
    const auto &u = places[*rc::gen::inRange<std::size_t>(0, places.size())],
               &v = places[*rc::gen::inRange<std::size_t>(0, places.size())];
    const int share = *rc::gen::inRange(1, 32);
    if (const auto m = Weights::combination(share, u, 32 - share, v))
      places.push_back(m->scaled(*rc::gen::inRange(-3, 4)));
  }
  return places.back();
}

RC_GTEST_PROP(ExactWeights, CombinationsAreExact, ()) {
  const auto u = random_place(), v = random_place();
  const int a = *rc::gen::inRange(1, 32), b = *rc::gen::inRange(1, 32);
  const auto m = Weights::combination(a, u, b, v);
  RC_PRE(m.has_value());
  for (std::size_t i = 0; i < 4; ++i)
    RC_ASSERT(Rational(m->values()[i]) ==
              a * Rational(u.values()[i]) + b * Rational(v.values()[i]));
}

// What is refused has a coordinate that does not fit in 52 bits beside the others.
RC_GTEST_PROP(ExactWeights, OnlyLongCombinationsAreRefused, ()) {
  const auto u = random_place(), v = random_place();
  const auto m = Weights::combination(1, u, 1, v);
  Rational largest = 0, smallest = 0;  // smallest: lowest set bit
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational sum = Rational(u.values()[i]) + Rational(v.values()[i]);
    if (sum == 0) continue;
    if (sum > largest) largest = sum;
    Rational bit = 1;
    while (denominator(Rational(sum / bit)) != 1) bit /= 2;
    while (denominator(Rational(sum / (2 * bit))) == 1) bit *= 2;
    if (smallest == 0 || bit < smallest) smallest = bit;
  }
  const bool fits = largest / smallest < Rational(std::int64_t{1} << 52);
  if (m) {
    RC_ASSERT(fits);
  } else {
    RC_ASSERT(largest / smallest * 1024 > Rational(std::int64_t{1} << 52));
  }
}

RC_GTEST_PROP(ExactWeights, OrderAlongAnEdgeIsThatOfTheRatio, ()) {
  const auto on_edge = [] {
    const int a = *rc::gen::inRange(0, 4000), b = *rc::gen::inRange(1, 4000);
    auto place = *Weights::combination(a, Weights::at_corner(1), b, Weights::at_corner(3));
    return place.scaled(*rc::gen::inRange(-3, 4));
  };
  const auto u = on_edge(), v = on_edge();
  const auto place = [](const Weights& w) -> Rational {
    const auto x = w.values();
    return Rational(x[3]) / (Rational(x[1]) + Rational(x[3]));
  };
  RC_ASSERT(u.comes_before(v, 1, 3) == (place(u) < place(v)));
  RC_ASSERT(u.comes_before(v, 3, 1) == (place(v) < place(u)));
}

}  // namespace
}  // namespace tensortopo::test
