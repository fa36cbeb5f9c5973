// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "zero_inside.hpp"

#include <utility>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {

namespace {

using Rows = std::vector<std::vector<Rational>>;

// Gauss-Jordan elimination of the matrix whose columns are the deviators. If they are dependent and
// all but the last are independent: the weights of those with which they make up the last.
bool depends_on_others(const std::vector<Deviator<Rational>>& deviators,
                       std::vector<Rational>& weights) {
  const std::size_t columns = deviators.size();
  Rows rows(5, std::vector<Rational>(columns));
  for (std::size_t c = 0; c < columns; ++c) {
    const auto& d = deviators[c];
    const std::array<Rational, 5> entries{d.a, d.b, d.xy, d.yz, d.xz};
    for (std::size_t r = 0; r < 5; ++r) rows[r][c] = entries[r];
  }
  for (std::size_t c = 0; c + 1 < columns; ++c) {
    std::size_t pivot = c;
    while (pivot < 5 && rows[pivot][c] == 0) ++pivot;
    if (pivot == 5) return false;
    std::swap(rows[pivot], rows[c]);
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < columns; ++k) rows[r][k] = rows[r][k] - factor * rows[c][k];
    }
  }
  for (std::size_t r = columns - 1; r < 5; ++r)
    if (rows[r][columns - 1] != 0) return false;
  weights.clear();
  for (std::size_t c = 0; c + 1 < columns; ++c)
    weights.push_back(rows[c][columns - 1] / rows[c][c]);
  return true;
}

}  // namespace

std::vector<Deviator<Rational>> exact_deviators(std::span<const SymmetricTensor<double>> tensors) {
  std::vector<Deviator<Rational>> result;
  for (const auto& t : tensors)
    result.push_back(
        deviator(SymmetricTensor<Rational>{Rational(t.xx), Rational(t.yy), Rational(t.zz),
                                           Rational(t.xy), Rational(t.yz), Rational(t.xz)}));
  return result;
}

bool has_zero_inside(std::span<const SymmetricTensor<double>> tensors) {
  const auto all = exact_deviators(tensors);
  // A combination with as few vertices as possible has positive weights, and all but one of its
  // deviators are independent.
  for (unsigned chosen = 1; chosen < (1u << all.size()); ++chosen) {
    std::vector<Deviator<Rational>> part;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (chosen >> i & 1) part.push_back(all[i]);
    std::vector<Rational> weights;
    if (part.size() < 2 || !depends_on_others(part, weights)) continue;
    bool opposite = true;
    for (const Rational& w : weights) opposite = opposite && sign_of(w) == Sign::negative;
    if (opposite) return true;
  }
  return false;
}

}  // namespace tensortopo
