// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Vectors with errors enclose what rational arithmetic finds of any points within the errors.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>

#include "distances/enclosed_triangles.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::detail {
namespace {

using Exact = Vector3<Rational>;
using test::Random;

Vector3<double> random_vector(Random& random) {
  const auto one = [&] { return random.uniform() - 0.5; };
  return {one(), one(), one()};
}

/// At an end of its error, of which the sign is drawn for each coordinate.
Exact end_of(const Enclosed& v, Random& random) {
  const auto end = [&](double value, double error) {
    return Rational(value) + (random.integer(0, 1) == 0 ? -1 : 1) * Rational(error);
  };
  return {end(v.value.x, v.error.x), end(v.value.y, v.error.y), end(v.value.z, v.error.z)};
}

/// The largest coordinate's error over its bound; 0 where there is neither.
double share(const Enclosed& bound, const Exact& exact) {
  const auto one = [](double value, double error, const Rational& x) {
    const double off = std::abs(static_cast<double>(Rational(value) - x));
    return off == 0 ? 0 : off / error;
  };
  return std::max({one(bound.value.x, bound.error.x, exact.x),
                   one(bound.value.y, bound.error.y, exact.y),
                   one(bound.value.z, bound.error.z, exact.z)});
}

TEST(EnclosedTriangles, EncloseWhatIsExact) {
  Random random(20261126);
  test::Compared compared("vectors that are not exact", 1000);
  double worst = 0;
  for (int trial = 0; trial < test::trials(2000, 1000); ++trial) {
    // Without errors; with small ones; with errors like the triangle, which itself may be thin.
    const double error = std::array{0.0, 1e-14, 1e-2}[static_cast<std::size_t>(trial) % 3];
    const double thin = trial % 2 == 0 ? 1 : 1e-10;
    std::array<Enclosed, 3> points;
    std::array<Exact, 3> exact;
    const auto first = random_vector(random);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto e = error * thin * random.uniform();
      points[i] = {first + thin * random_vector(random), {e, e / 2, e / 3}};
      exact[i] = end_of(points[i], random);
    }
    const Exact u = exact[1] - exact[0], v = exact[2] - exact[0], normal = cross(u, v);
    const Enclosed edge = minus(points[1], points[0]), found = normal_of(points, {0, 1, 2});
    for (const double s : {share(edge, u), share(found, normal)}) {
      EXPECT_LE(s, 1);
      worst = std::max(worst, s);
      compared.count(s > 0);
    }
    const auto direction = random_vector(random);
    const Exact d{Rational(direction.x), Rational(direction.y), Rational(direction.z)};
    EXPECT_LE(Rational(least_product(direction, found)), dot(d, normal));
    EXPECT_LE(Rational(least_product(edge, found)), dot(u, normal));
  }
  std::cout << "largest share of a bound: " << worst << '\n';
  EXPECT_GT(worst, 0.5);
}

}  // namespace
}  // namespace tensortopo::detail
