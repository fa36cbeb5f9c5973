// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The bounds on rounding of stability's arithmetic, against rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "traceless.hpp"

namespace tensortopo::stability {
namespace {

using test::Random;

/// What the derivation beside `kRounding` promises.
constexpr double kPromised = 0x1p-46;

Rational inner_of(const SymmetricTensor<Rational>& s, const SymmetricTensor<Rational>& t) {
  return s.xx * t.xx + s.yy * t.yy + s.zz * t.zz + 2 * (s.xy * t.xy + s.yz * t.yz + s.xz * t.xz);
}

/// Deviator of (S T + T S) / 2.
SymmetricTensor<Rational> product_of(const SymmetricTensor<Rational>& s,
                                     const SymmetricTensor<Rational>& t) {
  const std::array<std::array<Rational, 3>, 3> a{
      {{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}},
      b{{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
  const auto entry = [&](std::size_t i, std::size_t j) {
    Rational sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += a[i][k] * b[k][j] + b[i][k] * a[k][j];
    return Rational(sum / 2);
  };
  const Rational mean = (entry(0, 0) + entry(1, 1) + entry(2, 2)) / 3;
  return {entry(0, 0) - mean, entry(1, 1) - mean, entry(2, 2) - mean,
          entry(0, 1),        entry(1, 2),        entry(0, 2)};
}

double off(double value, const Rational& exact) {
  return std::abs(static_cast<double>(Rational(value) - exact));
}

TEST(Traceless, ResultsErrLessThanTheBound) {
  Random random(20261126);
  test::Compared compared("results that are not exact", 1000);
  double worst = 0;
  for (int trial = 0; trial < test::trials(2000); ++trial) {
    const auto given = random.tensor();
    // Half of them nearly uniaxial along another, so that products cancel.
    const Traceless s = traceless(deviator(given));
    const Traceless t = trial % 2 == 0 ? traceless(deviator(random.tensor()))
                                       : traceless(deviator(given + 1e-9 * random.tensor()));
    const auto exact_s = tensor_cast<Rational>(s), exact_t = tensor_cast<Rational>(t);
    const double sizes = norm(s) * norm(t);
    const auto expect = [&](double value, const Rational& exact) {
      const double error = off(value, exact) / sizes;
      EXPECT_LE(error, kPromised);
      worst = std::max(worst, error);
      compared.count(error > 0);
    };
    expect(inner(s, t), inner_of(exact_s, exact_t));
    const Traceless found = product(s, t);
    const auto exact = product_of(exact_s, exact_t);
    expect(found.xx, exact.xx), expect(found.yy, exact.yy), expect(found.zz, exact.zz);
    expect(found.xy, exact.xy), expect(found.yz, exact.yz), expect(found.xz, exact.xz);
  }
  EXPECT_LE(kPromised, kRounding / 4);
  std::cout << "largest error: " << worst / 0x1p-53 << " roundings of the norms' product\n";
}

}  // namespace
}  // namespace tensortopo::stability
