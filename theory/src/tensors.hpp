// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/theory/facts.hpp"
#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {

using Tensor = SymmetricTensor<Rational>;

// So that `facts` of any arithmetic can be asked for its numbers.
template <class FactsOf>
using ScalarOf = typename FactsOf::Scalar;

template <class Scalar>
Scalar squared(const Scalar& x) {
  return x * x;
}
template <class Scalar>
Scalar cubed(const Scalar& x) {
  return x * x * x;
}

/// 54 det^2 / |T|^6: the paper's definition of the mode, squared.
template <class Scalar>
Scalar mode_squared(const SymmetricTensor<Scalar>& t) {
  return Scalar(54) * squared(determinant(t)) / cubed(inner(t, t));
}

/// Eigenvalues of a tensor of mode mu(s) >= 0, times a positive number.
inline std::array<Rational, 3> eigenvalues_of(const Rational& s) {
  return {Rational(3) + s, Rational(-2) * s, s - Rational(3)};
}

template <class Scalar>
SymmetricTensor<Scalar> projection_to(const Vector3<Scalar>& e) {
  return {e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.y * e.z, e.x * e.z};
}

/// (u w^T + w u^T) / 2.
inline Tensor product_of(const Vector3<Rational>& u, const Vector3<Rational>& w) {
  const Rational two(2);
  return {u.x * w.x,
          u.y * w.y,
          u.z * w.z,
          (u.x * w.y + u.y * w.x) / two,
          (u.y * w.z + u.z * w.y) / two,
          (u.x * w.z + u.z * w.x) / two};
}

/// The identity times a number.
template <class Scalar>
SymmetricTensor<Scalar> isotropic(const Scalar& k) {
  return {k, k, k, Scalar(0), Scalar(0), Scalar(0)};
}

inline Rational fraction(int numerator, int denominator) {
  return Rational(numerator) / Rational(denominator);
}

}  // namespace tensortopo::theory
