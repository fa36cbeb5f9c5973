// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tensors.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo::theory {

/// A positive multiple of the characteristic tensor, or nothing below rank 4. Everything here is
/// homogeneous in it, so no root is needed to make it a unit tensor.
inline std::optional<Tensor> characteristic_multiple(const TetrahedronField<Rational>& field) {
  const Tensor n = to_tensor(characteristic_direction(field));
  if (n == Tensor{}) return std::nullopt;
  return n;
}

/// The tensor of mode parameter s, medium eigenvector v and dominant eigenvector d across v, times
/// |d|^2. It is in the field if and only if it is orthogonal to the characteristic tensor.
template <class Scalar>
SymmetricTensor<Scalar> tensor_with(const Scalar& s, const Vector3<Scalar>& v,
                                    const Vector3<Scalar>& d) {
  return Scalar(Scalar(3) + s) * projection_to(d) +
         Scalar(Scalar(-2) * s * dot(d, d)) * projection_to(v) +
         Scalar(s - Scalar(3)) * projection_to(cross(v, d));
}

/// The binary quadratic form p^2 A + 2 p q B + q^2 C that vanishes on the dominant directions
/// p e1 + q e2 of the field's tensors of mode parameter s with medium eigenvector e3.
template <class Scalar>
struct DominantForm {
  Scalar first, mixed, last;

  /// Positive for two directions, zero for one (or for all), negative for none.
  Scalar discriminant() const { return mixed * mixed - first * last; }
};

/// Made from the tensors themselves, not from a formula of the paper.
template <class Scalar>
DominantForm<Scalar> dominant_form(const SymmetricTensor<Scalar>& n,
                                   const std::array<Vector3<Scalar>, 3>& basis, const Scalar& s) {
  const Scalar first = inner(n, tensor_with(s, basis[2], basis[0]));
  const Scalar last = inner(n, tensor_with(s, basis[2], basis[1]));
  const Scalar sum = inner(n, tensor_with(s, basis[2], basis[0] + basis[1]));
  return {first, Scalar((sum - first - last) / Scalar(2)), last};
}

/// |n|^2 / 2 |v|^4 - |v|^2 v.n^2 v + weight (v.n v)^2: the paper's boundary function of n / |n|,
/// times |n|^2, homogeneous in v. Its weight is (1 - s^2) / 4.
template <class Scalar>
Scalar boundary_form(const SymmetricTensor<Scalar>& n, const Vector3<Scalar>& v,
                     const Scalar& weight) {
  const Vector3<Scalar> image = n * v;
  const Scalar size = dot(v, v), alpha = dot(v, image), beta = dot(image, image);
  return inner(n, n) * size * size / Scalar(2) - size * beta + weight * alpha * alpha;
}

/// (1 - s^2) / 4.
inline Rational boundary_weight(const Rational& s) { return (Rational(1) - s * s) / Rational(4); }

/// The columns of a basis in the numbers of the facts.
template <class FactsOf>
auto basis_in(const FactsOf& facts, const Basis& basis) {
  return std::array{facts.vector(basis[0]), facts.vector(basis[1]), facts.vector(basis[2])};
}

/// xy, xz, yz and diag(4, -5, 1): orthogonal to diag(2, 1, -3).
inline TetrahedronField<Rational> witness_field() {
  TetrahedronField<Rational> field;
  field.vertex = {deviator(Tensor{0, 0, 0, 1, 0, 0}), deviator(Tensor{0, 0, 0, 0, 0, 1}),
                  deviator(Tensor{0, 0, 0, 0, 1, 0}), deviator(Tensor{4, -5, 1, 0, 0, 0})};
  return field;
}

/// The basis of the axes.
inline Basis axes() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

/// Names a place on the sphere of a field.
inline std::string place(const Tensor& n, const Vector3<Rational>& v, const Rational& s) {
  return "characteristic tensor along " + text(n) + ", s = " + s.str() + ", v = " + text(v);
}

}  // namespace tensortopo::theory
