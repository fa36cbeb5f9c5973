// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/exact_side.hpp"

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/deviator.hpp"

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
                         std::span<const int> exponents, std::span<const double> weights,
                         const ModeValue& mode) {
  Deviator<Rational> t{};
  for (std::size_t i = 0; i < tensors.size(); ++i) {
    const auto& s = tensors[i];
    const SymmetricTensor<Rational> exact{Rational(s.xx), Rational(s.yy), Rational(s.zz),
                                          Rational(s.xy), Rational(s.yz), Rational(s.xz)};
    t = t + (Rational(weights[i]) * power_of_two(exponents[i])) * deviator(exact);
  }
  const Rational p = norm_form(t), q = determinant_form(t), mu = to_scalar<Rational>(mode);
  if (p == 0) return Sign::zero;
  const Sign side_of_q = sign_of(q), side_of_mu = sign_of(mu);
  if (side_of_q != side_of_mu)
    return static_cast<int>(side_of_q) > static_cast<int>(side_of_mu) ? Sign::positive
                                                                      : Sign::negative;
  const Sign larger = sign_of(Rational(Rational(2) * q * q - mu * mu * p * p * p));
  return side_of_q == Sign::negative ? -larger : larger;
}

}  // namespace tensortopo
