// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "level_strata.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "zero_inside.hpp"

namespace tensortopo {

namespace {

using Corners = std::span<const Deviator<Rational>>;

// Whether the mode is mu at every point of the simplex. A form of degree six on a simplex that is
// zero on the lattice of order six is zero.
bool is_constant(Corners corners, const Rational& mu) {
  constexpr int kDegree = 6;
  const Rational mu_squared = mu * mu;
  std::vector<int> weights(corners.size(), 0);
  const auto zero_below = [&](const auto& self, std::size_t corner, int left) -> bool {
    if (corner + 1 < corners.size()) {
      for (int w = 0; w <= left; ++w) {
        weights[corner] = w;
        if (!self(self, corner + 1, left - w)) return false;
      }
      return true;
    }
    weights[corner] = left;
    Deviator<Rational> t{};
    for (std::size_t i = 0; i < corners.size(); ++i) t = t + Rational(weights[i]) * corners[i];
    const Rational p = norm_form(t), q = determinant_form(t);
    return Rational(2) * q * q == mu_squared * p * p * p;
  };
  // The mode is then mu or -mu; the two do not meet where the tensors are not zero.
  return sign_of(determinant_form(corners[0])) == sign_of(mu) &&
         zero_below(zero_below, 0, kDegree);
}

bool is_constant_on_some(Corners corners, std::size_t size, const Rational& mu) {
  for (unsigned chosen = 1; chosen < (1u << corners.size()); ++chosen) {
    std::vector<Deviator<Rational>> part;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (chosen >> i & 1) part.push_back(corners[i]);
    if (part.size() == size && is_constant(part, mu)) return true;
  }
  return false;
}

// Weights with which four independent deviators make up a fifth one; nothing if they do not.
std::optional<std::array<Rational, 4>> weights_of(const Deviator<Rational>& t, Corners corners) {
  // Columns: the deviators, and t.
  const auto coordinates = [](const Deviator<Rational>& d) {
    return std::array<Rational, 5>{d.a, d.b, d.xy, d.yz, d.xz};
  };
  std::array<std::array<Rational, 5>, 5> rows;
  for (std::size_t c = 0; c < 5; ++c) {
    const auto column = coordinates(c < 4 ? corners[c] : t);
    for (std::size_t r = 0; r < 5; ++r) rows[r][c] = column[r];
  }
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    while (pivot < 5 && rows[pivot][c] == 0) ++pivot;
    if (pivot == 5) return std::nullopt;
    std::swap(rows[pivot], rows[c]);
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == c) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = 0; k < 5; ++k) rows[r][k] = rows[r][k] - factor * rows[c][k];
    }
  }
  if (rows[4][4] != 0) return std::nullopt;
  std::array<Rational, 4> weights;
  for (std::size_t c = 0; c < 4; ++c) weights[c] = rows[c][4] / rows[c][c];
  return weights;
}

// The only non-degenerate critical point of the mode is where the tensor commutes with the
// characteristic tensor N and is orthogonal to it: N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N.
bool is_at_saddle(Corners corners, const Rational& mu) {
  const Deviator<Rational> direction = characteristic_direction(
      TetrahedronField<Rational>{{corners[0], corners[1], corners[2], corners[3]}});
  const SymmetricTensor<Rational> n = to_tensor(direction);
  const Rational size = inner(n, n);
  if (size == 0) return false;
  const Deviator<Rational> critical =
      deviator(square(n)) - Rational(Rational(3) * determinant(n) / size) * direction;
  const Rational p = norm_form(critical), q = determinant_form(critical);
  if (p == 0 || Rational(2) * q * q != mu * mu * p * p * p) return false;
  const auto weights = weights_of(critical, corners);
  if (!weights) return false;
  const Sign first = sign_of((*weights)[0]);
  for (const Rational& w : *weights)
    if (sign_of(w) != first) return false;
  // Negative weights belong to the opposite tensor at the same point.
  return first != Sign::zero && first * sign_of(q) == sign_of(mu);
}

}  // namespace

UnresolvedReason level_stratum(std::span<const SymmetricTensor<double>> tensors,
                               const ModeValue& mode) {
  if (has_zero_inside(tensors)) return UnresolvedReason::zero_deviator_inside;
  const auto corners = exact_deviators(tensors);
  const auto mu = to_scalar<Rational>(mode);
  // What is constant on some vertices is so on the simplex of these and of those without deviator.
  const std::size_t zeros = 4 - corners.size();
  if (is_constant_on_some(corners, 4 - zeros, mu)) return UnresolvedReason::level_constant_in_cell;
  if (zeros < 2 && is_constant_on_some(corners, 3 - zeros, mu))
    return UnresolvedReason::level_constant_on_face;
  if (zeros < 1 && is_constant_on_some(corners, 2, mu))
    return UnresolvedReason::level_constant_on_edge;
  if (zeros == 0 && is_at_saddle(corners, mu)) return UnresolvedReason::critical_value_in_cell;
  return UnresolvedReason::budget_exhausted;
}

}  // namespace tensortopo
