// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "rational/rational_polynomial.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::detail {

/// A positive multiple in integers: of the same mode, and so are the values on spans of such.
inline Deviator<Rational> in_integers(const Deviator<Rational>& t) {
  std::array<Rational, 5> x{t.a, t.b, t.xy, t.yz, t.xz};
  make_primitive(x);
  return {x[0], x[1], x[2], x[3], x[4]};
}

/// A positive multiple of a deviator.
inline Deviator<Rational> exact_deviator(const SymmetricTensor<double>& t) {
  return in_integers(deviator(tensor_cast<Rational>(t)));
}

/// The tensors a + x b of a line, and the forms that depend on x: as `Line` in intervals.
struct RationalLine {
  RationalLine(const Deviator<Rational>& first, const Deviator<Rational>& along)
      : a(first), b(along), m(thrice(a)), k(thrice(b)) {
    const auto mm = square(m), kk = square(k);
    squares = {mm, square(m + k) - mm - kk, kk};
    norm = polynomial({norm_form(a), 2 * norm_form(a, b), norm_form(b)});
    // Q of a traceless tensor is a third of the trace of the cube of its multiple.
    determinant =
        polynomial({determinant_form(a), inner(mm, k), inner(kk, m), determinant_form(b)});
  }

  static RationalPolynomial polynomial(const std::vector<Rational>& coefficients) {
    return RationalPolynomial(coefficients.begin(), coefficients.end());
  }
  Deviator<Rational> at(const Rational& x) const { return a + x * b; }
  /// <M, T> and <M^2, T> for M three times the tensor.
  RationalPolynomial linear(const SymmetricTensor<Rational>& t) const {
    return polynomial({inner(m, t), inner(k, t)});
  }
  RationalPolynomial quadratic(const SymmetricTensor<Rational>& t) const {
    return polynomial({inner(squares[0], t), inner(squares[1], t), inner(squares[2], t)});
  }
  /// 2 Q^2 - c P^3, times a positive number: the sign of mode^2 - c.
  RationalPolynomial level_form(const Rational& c) const {
    return Rational(2 * denominator(c)) * determinant * determinant -
           Rational(numerator(c)) * (norm * norm * norm);
  }
  /// The sign of the mode's derivative along the line: zero where it is critical on it.
  RationalPolynomial increase() const {
    return Rational(2) * norm * determinant.prime() - Rational(3) * determinant * norm.prime();
  }
  /// The sign of the mode's derivative in the direction of another tensor.
  RationalPolynomial increase_towards(const Deviator<Rational>& t) const {
    return norm * quadratic(thrice(t)) - determinant * linear(thrice(t));
  }
  /// The binary cubic that vanishes at the N to which a tensor
  /// G = N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N belongs that is critical across the line.
  RationalPolynomial critical_cubic() const {
    return quadratic(m) * linear(k) - quadratic(k) * linear(m);
  }

  Deviator<Rational> a, b;
  SymmetricTensor<Rational> m, k;
  std::array<SymmetricTensor<Rational>, 3> squares;
  RationalPolynomial norm, determinant;  ///< P and Q
};

/// Two independent tensors orthogonal to three.
/// @pre the three are independent
inline std::array<Deviator<Rational>, 2> rational_complement(
    const std::array<Deviator<Rational>, 3>& t) {
  const Rational zero(0), one(1);
  std::array<Deviator<Rational>, 2> found;
  std::size_t n = 0;
  // Three tensors span no more than three of these axes.
  for (const Deviator<Rational>& axis : {Deviator<Rational>{one, zero, zero, zero, zero},
                                         {zero, one, zero, zero, zero},
                                         {zero, zero, one, zero, zero},
                                         {zero, zero, zero, one, zero},
                                         {zero, zero, zero, zero, one}}) {
    const auto across =
        in_integers(characteristic_direction(TetrahedronField<Rational>{{t[0], t[1], t[2], axis}}));
    const Rational norm = norm_form(across);
    if (norm == 0) continue;
    const Rational product = n == 0 ? zero : norm_form(found[0], across);
    if (n > 0 && product * product == norm * norm_form(found[0])) continue;
    found[n++] = across;
    if (n == 2) break;
  }
  return found;
}

}  // namespace tensortopo::detail
