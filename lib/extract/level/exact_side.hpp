// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Sign of mode - mu of a tensor, in a scalar whose arithmetic is exact.
///
/// @return zero also for the zero deviator, whose mode is undefined
template <class Exact>
Sign exact_side_of_level(const Deviator<Exact>& t, const Exact& mu) {
  const Exact p = norm_form(t), q = determinant_form(t);
  if (p == 0) return Sign::zero;
  const Sign side_of_q = sign_of(q), side_of_mu = sign_of(mu);
  if (side_of_q != side_of_mu)
    return static_cast<int>(side_of_q) > static_cast<int>(side_of_mu) ? Sign::positive
                                                                      : Sign::negative;
  const Sign larger = sign_of(Exact(Exact(2) * q * q - mu * mu * p * p * p));
  return side_of_q == Sign::negative ? -larger : larger;
}

/// Sign of mode - mu for the field of a simplex at barycentric coordinates, in exact rational
/// arithmetic: the last tier, asked only where rounding could have decided.
///
/// @param tensors   the vertex tensors as given
/// @param exponents the tensor of vertex i enters as `tensors[i] * 2^exponents[i]`
/// @param weights   barycentric coordinates, exact as they stand
/// @return zero also where the deviator vanishes, since the mode is undefined there
Sign exact_side_of_level(std::span<const SymmetricTensor<double>> tensors,
                         std::span<const int> exponents, std::span<const double> weights,
                         const ModeValue& mode);

/// The same at barycentric coordinates that are the sums of two doubles each.
Sign exact_side_of_level(std::span<const SymmetricTensor<double>> tensors,
                         std::span<const int> exponents, std::span<const double> high,
                         std::span<const double> low, const ModeValue& mode);

}  // namespace tensortopo
