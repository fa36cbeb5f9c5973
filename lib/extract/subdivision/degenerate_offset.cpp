// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/degenerate_offset.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo::detail {

namespace {

/// Steps of the power method; the two eigenvalues not sought are next to zero.
constexpr int kPowerSteps = 6;

}  // namespace

Vector3<double> simple_eigenvector(const Deviator<double>& t, int sign) {
  auto m = thrice(t);
  m = (sign * std::sqrt(6 / inner(m, m))) * m;
  m.xx += 1, m.yy += 1, m.zz += 1;
  Vector3<double> e{m.xx, m.xy, m.xz};
  for (const Vector3<double>& column :
       {Vector3<double>{m.xy, m.yy, m.yz}, Vector3<double>{m.xz, m.yz, m.zz}})
    if (dot(column, column) > dot(e, e)) e = column;
  for (int step = 0; step < kPowerSteps; ++step) e = unit(m * unit(e));
  return e;
}

Deviator<double> degenerate_offset(const Deviator<double>& t, int sign) {
  auto m = thrice(t);
  m = (1 / std::sqrt(inner(m, m))) * m;
  const auto e = simple_eigenvector(t, sign);
  const double k = 1.5 * dot(e, m * e);
  return deviator(m - SymmetricTensor<double>{k * e.x * e.x, k * e.y * e.y, k * e.z * e.z,
                                              k * e.x * e.y, k * e.y * e.z, k * e.x * e.z});
}

double sag_of_chord(const Deviator<double>& first, const Deviator<double>& last, int sign) {
  const auto at_first = degenerate_offset(first, sign), at_last = degenerate_offset(last, sign);
  const double m = std::sqrt(norm_form(first)), n = std::sqrt(norm_form(last));
  const auto sag =
      degenerate_offset(first + last, sign) - (1 / (m + n)) * (m * at_first + n * at_last);
  return std::sqrt(norm_form(sag) / std::max(norm_form(at_first), norm_form(at_last)));
}

int sag_halvings(double sag, int most) {
  int halvings = 0;
  while (std::ldexp(sag, -2 * halvings) > kLargestSag)
    if (++halvings > most) return 0;
  return halvings;
}

}  // namespace tensortopo::detail
