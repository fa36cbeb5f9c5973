// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/exact_signs.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ball.hpp"

namespace certificate {
namespace {

using Point = std::array<double, 3>;

/// x * 2^-unit, for a unit no larger than that of the last bit of x.
mpz_class whole(double x, int unit) {
  if (x == 0) return 0;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return mpz_class(std::ldexp(part, 53)) << static_cast<unsigned long>(exponent - 53 - unit);
}

/// The sign of an expression that is homogeneous in differences of coordinates, so that their unit does
/// not matter: in doubles, else in whole numbers.
template <class Expression>
int sign_of(std::initializer_list<const Point*> points, const Expression& expression) {
  const Ball ball = expression.template operator()<Ball>([](double x) { return Ball(x, 0); });
  if (std::abs(ball.value) > ball.error) return ball.value > 0 ? 1 : -1;
  int unit = 2000;
  for (const Point* p : points)
    for (const double x : *p) {
      int exponent = 0;
      std::frexp(x, &exponent);
      if (x != 0) unit = std::min(unit, exponent - 53);
    }
  return sgn(expression.template operator()<mpz_class>([&](double x) { return whole(x, unit); }));
}

}  // namespace

int side_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign_of({&a, &b, &c, &d}, [&]<class N>(const auto& number) {
    std::array<std::array<N, 3>, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      const N origin = number(a[k]);
      m[0][k] = number(b[k]) - origin;
      m[1][k] = number(c[k]) - origin;
      m[2][k] = number(d[k]) - origin;
    }
    const auto minor = [&](std::size_t i, std::size_t j) {
      return N(m[1][i] * m[2][j] - m[1][j] * m[2][i]);
    };
    return N(m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1));
  });
}

int turn(const Point& a, const Point& b, const Point& c, std::size_t axis) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return sign_of({&a, &b, &c}, [&]<class N>(const auto& number) {
    const auto minus = [&](const Point& p, std::size_t k) { return N(number(p[k]) - number(a[k])); };
    return N(minus(b, u) * minus(c, v) - minus(b, v) * minus(c, u));
  });
}

}  // namespace certificate
