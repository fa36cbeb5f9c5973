// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/binary_cubic.hpp"

#include <cmath>

#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
using Cubic = std::array<Scalar, 4>;

template <class Scalar>
Scalar value(const Cubic<Scalar>& f, const Scalar& x, const Scalar& y) {
  return ((f[0] * x + f[1] * y) * x + f[2] * y * y) * x + f[3] * y * y * y;
}

/// The coefficients of f(c x - s y, s x + c y).
template <class Scalar>
Cubic<Scalar> rotated(const Cubic<Scalar>& f, const Scalar& c, const Scalar& s) {
  const Scalar three(3), two(2);
  const Scalar c2 = c * c, s2 = s * s;
  return {value(f, c, s),
          -three * f[0] * c2 * s + f[1] * (c2 * c - two * c * s2) + f[2] * (two * c2 * s - s2 * s) +
              three * f[3] * s2 * c,
          three * f[0] * c * s2 + f[1] * (s2 * s - two * c2 * s) + f[2] * (c2 * c - two * c * s2) +
              three * f[3] * c2 * s,
          value(f, Scalar(-s), c)};
}

/// Real zeros of the monic t^3 + a t^2 + b t + c.
template <class Scalar>
std::vector<Scalar> monic_zeros(const Scalar& a, const Scalar& b, const Scalar& c) {
  using elementary::atan2;
  using elementary::cbrt;
  using elementary::cos;
  using std::abs;
  using std::sqrt;
  const Scalar three(3), two(2);
  const Scalar shift = a / three;
  const Scalar p = b / three - shift * shift;  // u^3 + 3 p u + 2 q
  const Scalar q = shift * shift * shift + (c - shift * b) / two;
  const Scalar discriminant = q * q + p * p * p;
  if (discriminant < Scalar(0)) {
    const Scalar radius = two * sqrt(-p);
    const Scalar angle = atan2(Scalar(sqrt(-discriminant)), Scalar(-q)) / three;
    const Scalar turn = two * pi<Scalar>() / three;
    return {radius * cos(angle) - shift, radius * cos(angle - turn) - shift,
            radius * cos(angle + turn) - shift};
  }
  const Scalar larger = abs(q) + sqrt(discriminant);
  if (larger == Scalar(0)) return {-shift};
  const Scalar magnitude = cbrt(larger);
  const Scalar u =
      q > Scalar(0) ? Scalar(p / magnitude - magnitude) : Scalar(magnitude - p / magnitude);
  return {u - shift};
}

}  // namespace

template <RealScalar Scalar>
std::vector<std::array<Scalar, 2>> binary_cubic_zeros(const std::array<Scalar, 4>& coefficients) {
  using std::abs;
  using std::sqrt;
  // Turn so that the leading coefficient is large: then no zero is near the chart's infinity.
  const Scalar three = Scalar(3) / Scalar(5), four = Scalar(4) / Scalar(5);
  const std::array<std::array<Scalar, 2>, 6> directions = {{{Scalar(1), Scalar(0)},
                                                            {Scalar(0), Scalar(1)},
                                                            {three, four},
                                                            {four, three},
                                                            {-three, four},
                                                            {-four, three}}};
  std::array<Scalar, 2> best = directions[0];
  for (const auto& d : directions)
    if (abs(value(coefficients, d[0], d[1])) > abs(value(coefficients, best[0], best[1]))) best = d;
  const Cubic<Scalar> f = rotated(coefficients, best[0], best[1]);
  if (f[0] == Scalar(0)) return {};
  std::vector<std::array<Scalar, 2>> zeros;
  for (Scalar t : monic_zeros<Scalar>(f[1] / f[0], f[2] / f[0], f[3] / f[0])) {
    for (int step = 0; step < 4; ++step) {
      const Scalar residual = value(f, t, Scalar(1));
      const Scalar slope = (Scalar(3) * f[0] * t + Scalar(2) * f[1]) * t + f[2];
      if (slope == Scalar(0)) break;
      const Scalar next = t - residual / slope;
      if (!(abs(value(f, next, Scalar(1))) < abs(residual))) break;
      t = next;
    }
    const Scalar scale = Scalar(1) / sqrt(t * t + Scalar(1));
    zeros.push_back({(best[0] * t - best[1]) * scale, (best[1] * t + best[0]) * scale});
  }
  return zeros;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                    \
  template std::vector<std::array<Scalar, 2>> binary_cubic_zeros<Scalar>( \
      const std::array<Scalar, 4>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
