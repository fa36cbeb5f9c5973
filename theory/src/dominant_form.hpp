// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {

using Tensor = SymmetricTensor<Rational>;

/// A positive multiple of the characteristic tensor, or nothing below rank 4. Everything here is
/// homogeneous in it, so no root is needed to make it a unit tensor.
inline std::optional<Tensor> characteristic_multiple(const TetrahedronField<Rational>& field) {
  const Tensor n = to_tensor(characteristic_direction(field));
  if (n == Tensor{}) return std::nullopt;
  return n;
}

/// The tensor of mode parameter s, medium eigenvector v and dominant eigenvector d across v, times
/// |d|^2. It is in the field if and only if it is orthogonal to the characteristic tensor.
inline Tensor tensor_with(const Rational& s, const Vector3<Rational>& v,
                          const Vector3<Rational>& d) {
  const Vector3<Rational> other = cross(v, d);
  const Rational size = dot(d, d);
  const auto projection = [](const Vector3<Rational>& e) {
    return Tensor{e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.y * e.z, e.x * e.z};
  };
  return Rational(Rational(3) + s) * projection(d) +
         Rational(Rational(-2) * s * size) * projection(v) +
         Rational(s - Rational(3)) * projection(other);
}

/// The binary quadratic form p^2 A + 2 p q B + q^2 C that vanishes on the dominant directions
/// p e1 + q e2 of the field's tensors of mode parameter s with medium eigenvector e3.
struct DominantForm {
  Rational first, mixed, last;

  bool is_zero() const { return first == 0 && mixed == 0 && last == 0; }
  /// Positive for two directions, zero for one (or for all), negative for none.
  Rational discriminant() const { return mixed * mixed - first * last; }
};

/// Made from the tensors themselves, not from a formula of the paper.
inline DominantForm dominant_form(const Tensor& n, const Basis& basis, const Rational& s) {
  const Rational first = inner(n, tensor_with(s, basis[2], basis[0]));
  const Rational last = inner(n, tensor_with(s, basis[2], basis[1]));
  const Rational sum = inner(n, tensor_with(s, basis[2], basis[0] + basis[1]));
  return {first, Rational((sum - first - last) / Rational(2)), last};
}

/// |n|^2 / 2 |v|^4 - |v|^2 v.n^2 v + weight (v.n v)^2: the paper's boundary function of n / |n|,
/// times |n|^2, homogeneous in v. Its weight is (1 - s^2) / 4.
inline Rational boundary_form(const Tensor& n, const Vector3<Rational>& v, const Rational& weight) {
  const Vector3<Rational> image = n * v;
  const Rational size = dot(v, v), alpha = dot(v, image), beta = dot(image, image);
  return inner(n, n) * size * size / Rational(2) - size * beta + weight * alpha * alpha;
}

/// (1 - s^2) / 4.
inline Rational boundary_weight(const Rational& s) { return (Rational(1) - s * s) / Rational(4); }

/// xy, xz, yz and diag(4, -5, 1): orthogonal to diag(2, 1, -3).
inline TetrahedronField<Rational> witness_field() {
  TetrahedronField<Rational> field;
  field.vertex = {deviator(Tensor{0, 0, 0, 1, 0, 0}), deviator(Tensor{0, 0, 0, 0, 0, 1}),
                  deviator(Tensor{0, 0, 0, 0, 1, 0}), deviator(Tensor{4, -5, 1, 0, 0, 0})};
  return field;
}

}  // namespace tensortopo::theory
