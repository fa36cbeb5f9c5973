// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dominant_form.hpp"

namespace tensortopo::theory {

/// Eigenvalues of the characteristic tensor, descending; or squares of the coordinates of a vector
/// in its frame, of sum one.
template <class Scalar>
using Triple = std::array<Scalar, 3>;
using Values = Triple<Rational>;
using Squares = Triple<Rational>;

/// Of the vectors along the characteristic eigenvectors.
inline const Squares kMajor = {1, 0, 0}, kMedium = {0, 1, 0}, kMinor = {0, 0, 1};

template <class Scalar>
Scalar squared_norm(const Triple<Scalar>& l) {
  return l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
}

/// v.T v.
template <class Scalar>
Scalar alpha_of(const Triple<Scalar>& l, const Triple<Scalar>& m) {
  return l[0] * m[0] + l[1] * m[1] + l[2] * m[2];
}

/// The boundary function at v, times the squared norm; only the squares of v's coordinates enter.
template <class Scalar>
Scalar boundary_at(const Triple<Scalar>& l, const Triple<Scalar>& m, const Scalar& weight) {
  const Scalar beta = l[0] * l[0] * m[0] + l[1] * l[1] * m[1] + l[2] * l[2] * m[2];
  return squared_norm(l) / Scalar(2) - beta + weight * squared(alpha_of(l, m));
}

/// The eigenvalues of the characteristic tensor, if the trial knows them and they are right.
inline std::optional<Values> characteristic_values(const Trial& trial) {
  if (!trial.frame || field_rank(trial.field) != 4) return std::nullopt;
  const Tensor n = tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors);
  for (const auto& d : trial.field.vertex) {
    if (inner(n, to_tensor(d)) != 0) return std::nullopt;
  }
  return trial.frame->eigenvalues;
}

inline constexpr const char* kNoFrame =
    "the characteristic eigenvectors are not known in rationals";

/// Random eigenvalues with rational singularities A e1 + B e3 and A e1 - B e3, 0 < A < B.
inline Values values_with_singularities(Random& random, Rational& a, Rational& b) {
  const Rational t = fraction(random.integer(1, 99), 100), size = Rational(1) + t * t;
  a = (Rational(1) - t * t) / size, b = (t + t) / size;
  if (b < a) std::swap(a, b);
  const Rational aa = a * a, bb = b * b, middle = bb - aa, three(3);
  return {Rational(middle + three * aa), middle, Rational(middle - three * bb)};
}

/// The eigenvalues up to a factor, and more numbers: what a check configures that sees no more.
inline std::vector<Rational> shape_of(const Values& l, std::vector<Rational> numbers = {}) {
  numbers.push_back(Rational(l[1] / l[0]));
  return numbers;
}

inline std::string triple_text(const Triple<Rational>& l) {
  return text(Vector3<Rational>{l[0], l[1], l[2]});
}

inline std::string frame_place(const Values& l, const Rational& s) {
  return "characteristic eigenvalues as " + triple_text(l) + ", s = " + s.str();
}

template <class FactsOf>
auto triple_in(const FactsOf& facts, const Triple<Rational>& l) {
  return std::array{facts.number(l[0]), facts.number(l[1]), facts.number(l[2])};
}

}  // namespace tensortopo::theory
