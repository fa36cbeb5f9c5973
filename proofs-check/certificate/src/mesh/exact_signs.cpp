// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/exact_signs.hpp"

#include <gmpxx.h>

#include <cmath>

#include "ball.hpp"

namespace certificate {
namespace {

using Point = std::array<double, 3>;

/// The sign of an expression of differences of coordinates: in doubles, else exactly.
template <class Expression>
int sign_of(const Expression& expression) {
  const Ball ball = expression.template operator()<Ball>([](double x) { return Ball(x, 0); });
  if (std::abs(ball.value) > ball.error) return ball.value > 0 ? 1 : -1;
  return sgn(expression.template operator()<mpq_class>([](double x) { return mpq_class(x); }));
}

}  // namespace

int side_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign_of([&]<class N>(const auto& number) {
    std::array<std::array<N, 3>, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      m[0][k] = number(b[k]) - number(a[k]);
      m[1][k] = number(c[k]) - number(a[k]);
      m[2][k] = number(d[k]) - number(a[k]);
    }
    const auto minor = [&](std::size_t i, std::size_t j) {
      return N(m[1][i] * m[2][j] - m[1][j] * m[2][i]);
    };
    return N(m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1));
  });
}

int turn(const Point& a, const Point& b, const Point& c, std::size_t axis) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return sign_of([&]<class N>(const auto& number) {
    const auto minus = [&](const Point& p, std::size_t k) { return N(number(p[k]) - number(a[k])); };
    return N(minus(b, u) * minus(c, v) - minus(b, v) * minus(c, u));
  });
}

}  // namespace certificate
