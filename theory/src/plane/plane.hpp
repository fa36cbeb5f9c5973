// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "integer.hpp"
#include "plane/polynomial.hpp"
#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::theory {

using IntegerTensor = SymmetricTensor<Integer>;

/// The tensors in a plane of a linear field: a space of three dimensions among the traceless ones,
/// and the two that are orthogonal to it.
struct Plane {
  /// Traceless; multiples of the tensors at a triangle's vertices by one positive number, so that
  /// coordinates in this basis are the weights of the vertices.
  std::array<IntegerTensor, 3> basis{};
  /// A basis of the orthogonal complement, traceless.
  std::array<IntegerTensor, 2> complement{};
};

/// The plane of a triangle; nothing if its tensors are dependent.
std::optional<Plane> plane_of(const TriangleField<Rational>& field);

/// The plane of the first three vertices.
std::optional<Plane> plane_of(const TetrahedronField<Rational>& field);

TriangleField<Rational> first_face(const TetrahedronField<Rational>& field);

/// The sum of three tensors with coefficients.
template <class Scalar>
SymmetricTensor<Scalar> combined(const std::array<IntegerTensor, 3>& basis,
                                 const Vector3<Scalar>& coefficients) {
  return coefficients.x * tensor_cast<Scalar>(basis[0]) +
         coefficients.y * tensor_cast<Scalar>(basis[1]) +
         coefficients.z * tensor_cast<Scalar>(basis[2]);
}

/// <T, B> for each tensor B of the basis.
template <class Scalar>
Vector3<Scalar> products(const SymmetricTensor<Scalar>& t,
                         const std::array<IntegerTensor, 3>& basis) {
  return {inner(t, tensor_cast<Scalar>(basis[0])), inner(t, tensor_cast<Scalar>(basis[1])),
          inner(t, tensor_cast<Scalar>(basis[2]))};
}

/// The matrix of <B_i, B_j>.
IntegerTensor gram_matrix(const std::array<IntegerTensor, 3>& basis);

/// The matrix of cofactors of a symmetric one.
template <class Scalar>
SymmetricTensor<Scalar> cofactors(const SymmetricTensor<Scalar>& m) {
  return {m.yy * m.zz - m.yz * m.yz, m.xx * m.zz - m.xz * m.xz, m.xx * m.yy - m.xy * m.xy,
          m.xz * m.yz - m.xy * m.zz, m.xy * m.xz - m.xx * m.yz, m.xy * m.yz - m.xz * m.yy};
}

/// Coordinates of the orthogonal projection of t to the plane, times a positive number.
template <class Scalar>
Vector3<Scalar> coordinates(const Plane& plane, const SymmetricTensor<Scalar>& t) {
  return tensor_cast<Scalar>(cofactors(gram_matrix(plane.basis))) * products(t, plane.basis);
}

/// (grad det) x G x at the tensor with coordinates x, G the Gram matrix: zero where the mode is
/// critical.
template <class Scalar>
Vector3<Scalar> critical_minors(const std::array<IntegerTensor, 3>& basis,
                                const SymmetricTensor<Scalar>& t) {
  return cross(products(square(t), basis), products(t, basis));
}

/// |T|^6 - 54 det(T)^2 of a traceless tensor: zero for degenerate ones.
template <class Scalar>
Scalar degeneracy_form(const SymmetricTensor<Scalar>& t) {
  const Scalar size = inner(t, t), cube = inner(square(t), t);
  return size * size * size - Scalar(6) * cube * cube;
}

/// At a critical tensor of the plane: positive if the mode has a strict extremum there, negative if
/// it has a saddle, zero if its Hessian is singular.
///
/// With t = tr T^3 and H the Hessian matrix of t / 3, the Hessian on the sphere |T| = 1 is that of
/// |T|^2 H - t G on the vectors x' with x'.G x = 0, and p.adj(K) p is the determinant of K on the
/// vectors orthogonal to p, times |p|^2.
template <class Scalar>
Scalar morse_form(const std::array<IntegerTensor, 3>& basis, const SymmetricTensor<Scalar>& t) {
  const auto second = [&](std::size_t i, std::size_t j) {
    const IntegerTensor product = square(basis[i] + basis[j]) - square(basis[i]) - square(basis[j]);
    return inner(t, tensor_cast<Scalar>(product));
  };
  const SymmetricTensor<Scalar> hessian = {second(0, 0), second(1, 1), second(2, 2),
                                           second(0, 1), second(1, 2), second(0, 2)};
  const Scalar size = inner(t, t), cube = inner(square(t), t);
  const auto on_sphere = size * hessian - cube * tensor_cast<Scalar>(gram_matrix(basis));
  const Vector3<Scalar> normal = products(t, basis);
  return dot(normal, cofactors(on_sphere) * normal);
}

}  // namespace tensortopo::theory
