// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The bound on the rounding of a quadratic form, against rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/quadric/quadric_form.hpp"

namespace tensortopo::test {
namespace {

/// Tensors of which the trace, the diagonal of the deviator or all but one component is small
/// beside what it is computed from.
SymmetricTensor<double> cancelling_tensor(Random& random) {
  SymmetricTensor<double> t = random.tensor();
  const int kind = random.integer(0, 3);
  if (kind == 1) t.zz = -t.xx - t.yy;
  if (kind == 2) t.yy = t.xx * (1 + 1e-12), t.zz = t.xx * (1 - 1e-13);
  if (kind == 3) t = std::ldexp(1.0, random.integer(-60, 0)) * t;
  return t;
}

int exponent_of(const TetTensors& tensors) {
  double largest = 0;
  for (const auto& t : tensors)
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
      largest = std::max(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

TEST(QuadricForm, ErrsLessThanItsBound) {
  Random random(20261126);
  Compared compared("forms that are not exact", 1000);
  double worst = 0;
  for (int trial = 0; trial < trials(2000, 1000); ++trial) {
    TetTensors tensors;
    for (auto& t : tensors) t = cancelling_tensor(random);
    const auto kind = std::array{Invariant::magnitude, Invariant::anisotropy,
                                 Invariant::deviator_magnitude}[static_cast<std::size_t>(trial) % 3];
    const QuadraticLevel level(InvariantLevel::parse(kind, trial % 2 == 0 ? "7/10" : "1/97"));
    const QuadricForm form(level, {&tensors[0], &tensors[1], &tensors[2], &tensors[3]});
    const Rational scale(std::ldexp(1.0, -2 * exponent_of(tensors)));
    // At two places with small whole coordinates, as the bound is stated.
    std::array<int, 4> p{}, q{};
    for (std::size_t i = 0; i < 4; ++i) p[i] = random.integer(0, 64), q[i] = random.integer(0, 64);
    double value = 0, sizes[2]{};
    Rational exact = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      sizes[0] += p[i] * form.size(i), sizes[1] += q[i] * form.size(i);
      for (std::size_t j = 0; j < 4; ++j) {
        value += p[i] * q[j] * form[i][j];
        exact += p[i] * q[j] * form.exact(i, j) * scale;
      }
    }
    if (sizes[0] < QuadricForm::kSmallestSize || sizes[1] < QuadricForm::kSmallestSize) continue;
    const double error = std::abs(static_cast<double>(Rational(value) - exact));
    ASSERT_LE(error, QuadricForm::kError * sizes[0] * sizes[1]);
    worst = std::max(worst, error / (QuadricForm::kError * sizes[0] * sizes[1]));
    compared.count(error > 0);
  }
  std::cout << "largest share of the bound: " << worst << '\n';
}

}  // namespace
}  // namespace tensortopo::test
