// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::detail {

template <class Scalar>
using Rows4 = std::array<std::array<Scalar, 5>, 4>;

/// The coordinates a, b, xy, yz, xz of a deviator as an array.
template <class Scalar>
constexpr std::array<Scalar, 5> coordinates(const Deviator<Scalar>& d) {
  return {d.a, d.b, d.xy, d.yz, d.xz};
}

/// The five 4x4 minors of four rows: entry j leaves out column j and carries no sign.
///
/// Laplace expansion by the first two rows. With Permanent, every subtraction becomes an addition:
/// of absolute values that gives the sum of the magnitudes of all monomials, of which the rounding
/// error of the determinant is a small multiple.
template <bool Permanent, class Scalar>
constexpr std::array<Scalar, 5> minors(const Rows4<Scalar>& rows) {
  const auto minus = [](const Scalar& x, const Scalar& y) {
    if constexpr (Permanent)
      return Scalar(x + y);
    else
      return Scalar(x - y);
  };
  const auto minor2 = [&](std::size_t row, std::size_t i, std::size_t j) {
    return minus(rows[row][i] * rows[row + 1][j], rows[row][j] * rows[row + 1][i]);
  };
  std::array<std::array<Scalar, 5>, 5> top{}, bottom{};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) {
      top[i][j] = minor2(0, i, j);
      bottom[i][j] = minor2(2, i, j);
    }
  std::array<Scalar, 5> result{};
  for (std::size_t skipped = 0; skipped < 5; ++skipped) {
    std::array<std::size_t, 4> k{};
    for (std::size_t j = 0, n = 0; j < 5; ++j)
      if (j != skipped) k[n++] = j;
    const Scalar outer =
        top[k[0]][k[1]] * bottom[k[2]][k[3]] + top[k[2]][k[3]] * bottom[k[0]][k[1]];
    const Scalar middle =
        top[k[0]][k[2]] * bottom[k[1]][k[3]] + top[k[1]][k[3]] * bottom[k[0]][k[2]];
    const Scalar inner =
        top[k[0]][k[3]] * bottom[k[1]][k[2]] + top[k[1]][k[2]] * bottom[k[0]][k[3]];
    result[skipped] = minus(outer, middle) + inner;
  }
  return result;
}

/// The deviator whose `norm_form` with any t is 6 times the dot product of `covector` with the
/// coordinates of t.
template <class Scalar>
constexpr Deviator<Scalar> from_covector(const std::array<Scalar, 5>& covector) {
  const Scalar two(2);
  return {two * (two * covector[0] - covector[1]), two * (two * covector[1] - covector[0]),
          covector[2], covector[3], covector[4]};
}

}  // namespace tensortopo::detail
