// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/degenerate_throughout.hpp"

#include <algorithm>

#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/points/exact_direction.hpp"

namespace tensortopo {
namespace {

using Components = std::array<Rational, 5>;

Components components_of(const Deviator<Rational>& d) { return {d.a, d.b, d.xy, d.yz, d.xz}; }

/// Far from parallel, by doubles. Each component of the deviators has one rounding, so the square
/// of the cosine of parallel ones is 1 up to some 1e-14; overflow and zeros say nothing.
bool are_not_parallel(const SymmetricTensor<double>& s, const SymmetricTensor<double>& t) {
  const Deviator<double> a = deviator(s), b = deviator(t);
  const double mixed = norm_form(a, b);
  return mixed * mixed < (1 - 1e-9) * (norm_form(a) * norm_form(b));
}

}  // namespace

bool is_degenerate_throughout(const std::array<ScaledTensor, 4>& tensors, bool linear) {
  for (std::size_t i = 1; i < 4; ++i)
    if (are_not_parallel(tensors[0].tensor, tensors[i].tensor)) return false;
  std::array<Components, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = components_of(exact_deviator<Rational>(tensors[i]));
  const auto is_zero_row = [](const Components& row) {
    return std::all_of(row.begin(), row.end(), [](const Rational& x) { return x == 0; });
  };
  const auto first = static_cast<std::size_t>(
      std::find_if_not(rows.begin(), rows.end(), is_zero_row) - rows.begin());
  if (first == 4) return false;
  const auto pivot =
      static_cast<std::size_t>(std::find_if(rows[first].begin(), rows[first].end(),
                                            [](const Rational& x) { return x != 0; }) -
                               rows[first].begin());
  const bool is_positive = rows[first][pivot] > 0;
  bool some_same = true, some_opposite = false;  // multiples, by sign
  for (std::size_t i = first + 1; i < 4; ++i) {
    for (std::size_t c = 0; c < 5; ++c)
      if (rows[i][c] * rows[first][pivot] != rows[first][c] * rows[i][pivot]) return false;
    const int sign = rows[i][pivot].sign();
    some_opposite = some_opposite || (sign != 0 && (sign > 0) != is_positive);
  }
  const TensorKind kind = kind_of(exact_deviator<Rational>(tensors[first]));
  return kind.degenerate && (kind.linear == linear ? some_same : some_opposite);
}

}  // namespace tensortopo
