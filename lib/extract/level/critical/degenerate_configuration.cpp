// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/critical/degenerate_configuration.hpp"

#include <span>
#include <vector>

#include "extract/level/critical/saddle_level.hpp"
#include "extract/level/critical/zero_inside.hpp"
#include "tensortopo/field/critical_values.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"

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
  return sign_of(determinant_form(corners[0])) == sign_of(mu) && zero_below(zero_below, 0, kDegree);
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

}  // namespace

bool is_level_constant(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode) {
  return is_constant(exact_deviators(tensors), to_scalar<Rational>(mode));
}

UnresolvedReason degenerate_configuration(std::span<const SymmetricTensor<double>> tensors,
                                          const ModeValue& mode) {
  if (has_zero_inside(tensors)) return UnresolvedReason::zero_deviator_inside;
  const auto corners = exact_deviators(tensors);
  const auto mu = to_scalar<Rational>(mode);
  // What is constant on some vertices is so on the simplex of these and of those isotropic.
  const std::size_t zeros = 4 - corners.size();
  if (is_constant_on_some(corners, 4 - zeros, mu)) return UnresolvedReason::level_constant_in_cell;
  if (zeros < 2 && is_constant_on_some(corners, 3 - zeros, mu))
    return UnresolvedReason::level_constant_on_face;
  if (zeros < 1 && is_constant_on_some(corners, 2, mu))
    return UnresolvedReason::level_constant_on_edge;
  if (zeros == 0 && is_level_at_saddle(tensors, mode))
    return UnresolvedReason::critical_value_in_cell;
  for (std::size_t i = 0; i < tensors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_critical_on_edge(tensors[i], tensors[j], mode))
        return UnresolvedReason::critical_value_on_edge;
  for (std::size_t i = 2; i < tensors.size(); ++i)
    for (std::size_t j = 1; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (is_critical_on_plane({tensors[i], tensors[j], tensors[k]}, mode))
          return UnresolvedReason::critical_value_on_face;
  return UnresolvedReason::budget_exhausted;
}

}  // namespace tensortopo
