// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Exact points of a simplex, by weights of its corners up to a positive factor.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>

namespace certificate {

template <std::size_t N>
using Place = std::array<mpz_class, N>;

template <std::size_t N>
mpz_class determinant(const std::array<Place<N>, N>& rows) {
  if constexpr (N == 1) {
    return rows[0][0];
  } else {
    mpz_class sum;
    for (std::size_t i = 0; i < N; ++i) {
      if (rows[i][0] == 0) continue;
      std::array<Place<N - 1>, N - 1> minor;
      for (std::size_t r = 0; r < N; ++r)
        if (r != i) std::copy(rows[r].begin() + 1, rows[r].end(), minor[r - (r > i)].begin());
      sum += (i % 2 == 0 ? 1 : -1) * rows[i][0] * determinant(minor);
    }
    return sum;
  }
}

/// The weights of a point, or direction, at corners that are given like it (by Cramer's rule).
template <std::size_t N>
Place<N> weights_at(const std::array<Place<N>, N>& corners, const Place<N>& point) {
  const int turn = sgn(determinant(corners));
  Place<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    auto replaced = corners;
    replaced[i] = point;
    result[i] = turn * determinant(replaced);
  }
  return result;
}

/// All but one of a point's coordinates, or of a tetrahedron's corners.
template <class T>
std::array<T, 3> without(const std::array<T, 4>& all, std::size_t opposite) {
  std::array<T, 3> result;
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != opposite) result[n++] = all[i];
  return result;
}

}  // namespace certificate
