// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/signature.hpp"

#include <cstddef>

namespace tensortopo::theory {
namespace {

using Matrix = std::vector<std::vector<Rational>>;

// Adds a multiple of one basis vector to another.
void add_multiple(Matrix& m, std::size_t to, std::size_t from, const Rational& factor) {
  for (std::size_t k = 0; k < m.size(); ++k) m[to][k] = m[to][k] + factor * m[from][k];
  for (std::size_t k = 0; k < m.size(); ++k) m[k][to] = m[k][to] + factor * m[k][from];
}

// Makes a diagonal entry other than zero, if the form is not zero on the vectors that are left.
bool find_pivot(Matrix& m, const std::vector<bool>& done, std::size_t& pivot) {
  const std::size_t n = m.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!done[i] && m[i][i] != 0) return pivot = i, true;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (done[i] || done[j] || m[i][j] == 0) continue;
      add_multiple(m, i, j, Rational(1));
      return pivot = i, true;
    }
  return false;
}

}  // namespace

Signature signature(Matrix m) {
  Signature result;
  std::vector<bool> done(m.size(), false);
  std::size_t pivot = 0, found = 0;
  for (; find_pivot(m, done, pivot); ++found) {
    done[pivot] = true;
    ++(m[pivot][pivot] > 0 ? result.positive : result.negative);
    for (std::size_t i = 0; i < m.size(); ++i)
      if (!done[i]) add_multiple(m, i, pivot, -m[i][pivot] / m[pivot][pivot]);
  }
  result.zero = static_cast<int>(m.size() - found);
  return result;
}

}  // namespace tensortopo::theory
