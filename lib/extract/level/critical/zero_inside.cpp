// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/critical/zero_inside.hpp"

#include <utility>

#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {

std::vector<Deviator<Rational>> exact_deviators(std::span<const SymmetricTensor<double>> tensors) {
  std::vector<Deviator<Rational>> result;
  for (const auto& t : tensors) result.push_back(deviator(tensor_cast<Rational>(t)));
  return result;
}

std::optional<std::vector<Rational>> weights_making(const Deviator<Rational>& t,
                                                    std::span<const Deviator<Rational>> others) {
  // Gauss-Jordan elimination of the matrix whose columns are the others, and t.
  const std::size_t last = others.size();
  std::vector<std::vector<Rational>> rows(5, std::vector<Rational>(last + 1));
  for (std::size_t c = 0; c <= last; ++c) {
    const auto& d = c < last ? others[c] : t;
    const std::array<Rational, 5> entries{d.a, d.b, d.xy, d.yz, d.xz};
    for (std::size_t r = 0; r < 5; ++r) rows[r][c] = entries[r];
  }
  for (std::size_t c = 0; c < last; ++c) {
    std::size_t pivot = c;
    while (pivot < 5 && rows[pivot][c] == 0) ++pivot;
    if (pivot == 5) return std::nullopt;
    std::swap(rows[pivot], rows[c]);
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= last; ++k) rows[r][k] = rows[r][k] - factor * rows[c][k];
    }
  }
  for (std::size_t r = last; r < 5; ++r)
    if (rows[r][last] != 0) return std::nullopt;
  std::vector<Rational> weights;
  for (std::size_t c = 0; c < last; ++c) weights.push_back(rows[c][last] / rows[c][c]);
  return weights;
}

bool has_zero_inside(std::span<const SymmetricTensor<double>> tensors) {
  const auto all = exact_deviators(tensors);
  // A combination with as few vertices as possible has positive weights, and all but one of its
  // deviators are independent.
  for (unsigned chosen = 1; chosen < (1u << all.size()); ++chosen) {
    std::vector<Deviator<Rational>> part;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (chosen >> i & 1) part.push_back(all[i]);
    if (part.size() < 2) continue;
    const auto weights = weights_making(part.back(), std::span(part).first(part.size() - 1));
    if (!weights) continue;
    bool opposite = true;
    for (const Rational& w : *weights) opposite = opposite && sign_of(w) == Sign::negative;
    if (opposite) return true;
  }
  return false;
}

}  // namespace tensortopo
