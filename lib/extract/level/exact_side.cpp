// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/exact_side.hpp"

#include <vector>

#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {

namespace {

/// 2^e as a rational.
Rational power_of_two(int e) {
  boost::multiprecision::mpz_int power = 1;
  power <<= (e < 0 ? -e : e);
  return e < 0 ? Rational(1) / Rational(power) : Rational(power);
}

}  // namespace

Sign exact_side_of_level(std::span<const SymmetricTensor<double>> tensors,
                         std::span<const int> exponents, std::span<const double> high,
                         std::span<const double> low, const ModeValue& mode) {
  Deviator<Rational> t{};
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    const auto& s = tensors[i];
    const auto exact = tensor_cast<Rational>(s);
    t = t + ((Rational(high[i]) + Rational(low[i])) * power_of_two(exponents[i])) * deviator(exact);
  }
  return exact_side_of_level(t, to_scalar<Rational>(mode));
}

Sign exact_side_of_level(std::span<const SymmetricTensor<double>> tensors,
                         std::span<const int> exponents, std::span<const double> weights,
                         const ModeValue& mode) {
  const std::vector<double> nothing(weights.size());
  return exact_side_of_level(tensors, exponents, weights, nothing, mode);
}

}  // namespace tensortopo
