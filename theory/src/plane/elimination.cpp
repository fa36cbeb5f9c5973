// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/elimination.hpp"

#include "tensortopo/algebra/barycentric_polynomial.hpp"

namespace tensortopo::theory {
namespace {

template <std::size_t Degree>
using IntegerForm = BarycentricPolynomial<Integer, 3, Degree>;

// A form at (s, t, 1): its coefficients as a polynomial in t are polynomials in s.
template <std::size_t Degree>
std::array<Polynomial, Degree + 1> powers_of_t(const IntegerForm<Degree>& form) {
  std::array<Polynomial, Degree + 1> result;
  for (std::size_t i = 0; i < form.size; ++i) {
    const auto& exponent = form.exponents[i];
    result[exponent[1]].set_coefficient(exponent[0], form.coefficients[i]);
  }
  return result;
}

// Coefficients c_ij of (a(x) b(y) - a(y) b(x)) / (x - y). The determinant of this matrix is the
// resultant up to sign, and (1, t, t^2, ...) is in its kernel if t is a common zero.
template <std::size_t Size>
Polynomial bezout(const std::array<Polynomial, Size>& a, const std::array<Polynomial, Size>& b,
                  std::size_t i, std::size_t j) {
  Polynomial sum;
  for (std::size_t k = 0; k <= i && j + k + 1 < Size; ++k) {
    sum = sum + a[j + k + 1] * b[i - k] - a[i - k] * b[j + k + 1];
  }
  return sum;
}

// Twice tr(B_i B_j B_k) for k = 1, 2, 3, as a linear form.
IntegerForm<1> linear_form(const IntegerTensor& bi, const IntegerTensor& bj,
                           const std::array<IntegerTensor, 3>& basis) {
  const IntegerTensor twice = square(bi + bj) - square(bi) - square(bj);
  IntegerForm<1> form;
  for (std::size_t k = 0; k < 3; ++k) form.coefficients[k] = inner(twice, basis[k]);
  return form;
}

IntegerForm<1> variable(std::size_t j) {
  IntegerForm<1> form;
  form.coefficients[j] = 1;
  return form;
}

// Twice <T^2, B_i>; the solutions do not mind a common factor.
IntegerForm<2> gradient(std::size_t i, const std::array<IntegerTensor, 3>& basis) {
  IntegerForm<2> sum;
  for (std::size_t j = 0; j < 3; ++j) {
    sum = sum + variable(j) * linear_form(basis[i], basis[j], basis);
  }
  return sum;
}

IntegerForm<1> metric(std::size_t i, const std::array<IntegerTensor, 3>& basis) {
  IntegerForm<1> form;
  for (std::size_t k = 0; k < 3; ++k) form.coefficients[k] = inner(basis[i], basis[k]);
  return form;
}

}  // namespace

Elimination eliminate(const std::array<IntegerTensor, 3>& basis) {
  std::array<IntegerForm<2>, 3> f;
  std::array<IntegerForm<1>, 3> p;
  for (std::size_t i = 0; i < 3; ++i) f[i] = gradient(i, basis), p[i] = metric(i, basis);
  const auto a = powers_of_t(p[2] * f[1] - p[1] * f[2]);
  const auto b = powers_of_t(p[0] * f[2] - p[2] * f[0]);
  const SymmetricTensor<Polynomial> matrix = {bezout(a, b, 0, 0), bezout(a, b, 1, 1),
                                              bezout(a, b, 2, 2), bezout(a, b, 0, 1),
                                              bezout(a, b, 1, 2), bezout(a, b, 0, 2)};
  Elimination result;
  result.proper = !a[3].is_zero() || !b[3].is_zero();
  result.all = determinant(matrix);
  // Of corank one at a simple zero of its determinant, so that the cofactors are as the products of
  // 1, t and t^2.
  const auto minors = cofactors(matrix);
  result.solution = {Polynomial::variable() * minors.xx, minors.xy, minors.xx};
  const auto line = powers_of_t(p[2]);
  const auto conic = powers_of_t(f[2]);
  result.spurious =
      conic[0] * line[1] * line[1] - conic[1] * line[0] * line[1] + conic[2] * line[0] * line[0];
  return result;
}

Conics eliminate(const IntegerTensor& first, const IntegerTensor& second) {
  // In the order of the exponents: s^2, s t, s, t^2, t, 1.
  const auto form = [](const IntegerTensor& m) {
    const Integer two(2);
    return powers_of_t(IntegerForm<2>{{m.xx, two * m.xy, two * m.xz, m.yy, two * m.yz, m.zz}});
  };
  const auto a = form(first), b = form(second);
  const Polynomial corner = bezout(a, b, 0, 0), side = bezout(a, b, 0, 1),
                   last = bezout(a, b, 1, 1);
  return {!a[2].is_zero() || !b[2].is_zero(),
          corner * last - side * side,
          {Polynomial::variable() * last, -side, last}};
}

}  // namespace tensortopo::theory
