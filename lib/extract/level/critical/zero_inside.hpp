// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// The deviators of tensors, without rounding.
std::vector<Deviator<Rational>> exact_deviators(std::span<const SymmetricTensor<double>> tensors);

/// The weights with which independent deviators make up another one; nothing if they do not, or are
/// dependent.
std::optional<std::vector<Rational>> weights_making(const Deviator<Rational>& t,
                                                    std::span<const Deviator<Rational>> others);

/// Whether the deviator vanishes somewhere in the simplex with these vertex tensors, decided in
/// rationals. Requires at most four tensors, whose deviators are not zero.
bool has_zero_inside(std::span<const SymmetricTensor<double>> tensors);

/// False for most simplices in which the deviator vanishes nowhere, at little cost; true for all in
/// which it does. Requires deviators scaled to P in [3, 12).
template <std::size_t Vertices>
bool may_have_zero_inside(const std::array<Deviator<double>, Vertices>& tensors) {
  // In the half-space of their sum.
  Deviator<double> sum = tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) sum = sum + tensors[i];
  bool is_pointed = true;
  for (const auto& t : tensors) is_pointed = is_pointed && norm_form(sum, t) > std::ldexp(1.0, -40);
  if (is_pointed) return false;
  // Independent: the pivots of their Gram matrix, squared distances to the span of those before,
  // are exact to 50 roundings or so of numbers below 12.
  std::array<std::array<double, Vertices>, Vertices> gram;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = 0; j < Vertices; ++j) gram[i][j] = norm_form(tensors[i], tensors[j]);
  for (std::size_t c = 0; c < Vertices; ++c) {
    // Errors are multiplied by at most 12 over a pivot in each step.
    if (!(gram[c][c] > std::ldexp(1.0, -8))) return true;
    for (std::size_t r = c + 1; r < Vertices; ++r) {
      const double factor = gram[r][c] / gram[c][c];
      for (std::size_t k = c; k < Vertices; ++k) gram[r][k] -= factor * gram[c][k];
    }
  }
  return false;
}

}  // namespace tensortopo
