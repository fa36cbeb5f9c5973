// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/manifold/asymmetric_field.hpp"

#include <cmath>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
Matrix2<Scalar> product(const Matrix2<Scalar>& m, const Matrix2<Scalar>& n) {
  return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c,
          m.c * n.b + m.d * n.d};
}

template <class Scalar>
std::array<Scalar, 2> unit(const Scalar& x, const Scalar& y) {
  using std::sqrt;
  const Scalar norm = sqrt(x * x + y * y);
  if (norm == Scalar(0)) return {Scalar(1), Scalar(0)};
  return {x / norm, y / norm};
}

}  // namespace

template <RealScalar Scalar>
std::array<Vector3<Scalar>, 2> plane_basis(const Vector3<Scalar>& v) {
  using std::abs;
  using std::sqrt;
  const Scalar zero(0), one(1);
  // The axis least aligned with v.
  Vector3<Scalar> axis = {one, zero, zero};
  if (abs(v.y) < abs(v.x) && abs(v.y) <= abs(v.z))
    axis = {zero, one, zero};
  else if (abs(v.z) < abs(v.x))
    axis = {zero, zero, one};
  Vector3<Scalar> e1 = axis - dot(axis, v) * v;
  e1 = unit(e1);
  return {e1, cross(v, e1)};
}

template <RealScalar Scalar>
Matrix2<Scalar> asymmetric_tensor(const CharacteristicTensor<Scalar>& characteristic,
                                  const ModeParameter<Scalar>& mode,
                                  const std::array<Vector3<Scalar>, 2>& basis) {
  using std::sqrt;
  const auto& [e1, e2] = basis;
  const auto& t = characteristic.tensor;
  const Scalar off = dot(e1, t * e2);
  const Matrix2<Scalar> projected = {dot(e1, t * e1), off, off, dot(e2, t * e2)};
  // Half angles of theta/2 +- pi/4 without trigonometry: cos(theta/2 + pi/4) = sin(pi/4 - theta/2)
  // = sqrt((1 - s) / 2), and its sine is sqrt((1 + s) / 2).
  const Scalar two(2);
  const Scalar small = sqrt(mode.one_minus_s / two), large = sqrt((Scalar(1) + mode.s) / two);
  const Matrix2<Scalar> left = {small, -large, large, small};
  const Matrix2<Scalar> right = {large, small, -small, large};
  return product(product(left, projected), right);
}

template <RealScalar Scalar>
std::optional<Eigensystem2<Scalar>> real_eigensystem(const Matrix2<Scalar>& m) {
  using std::abs;
  using std::sqrt;
  const Scalar half_difference = (m.a - m.d) / Scalar(2), mean = (m.a + m.d) / Scalar(2);
  const Scalar discriminant = half_difference * half_difference + m.b * m.c;
  if (discriminant < Scalar(0)) return std::nullopt;
  const Scalar root = sqrt(discriminant);
  // Rows of M - value I are (half_difference -+ root, b) and (c, -half_difference -+ root); the
  // vector comes from the row in which nothing cancels.
  const auto vector = [&](const Scalar& signed_root) {
    const Scalar first = half_difference - signed_root, second = -half_difference - signed_root;
    return abs(first) > abs(second) ? unit(m.b, Scalar(-first)) : unit(Scalar(-second), m.c);
  };
  return Eigensystem2<Scalar>{{mean + root, mean - root}, {vector(root), vector(Scalar(-root))}};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                               \
  template std::array<Vector3<Scalar>, 2> plane_basis(const Vector3<Scalar>&);       \
  template Matrix2<Scalar> asymmetric_tensor(const CharacteristicTensor<Scalar>&,    \
                                             const ModeParameter<Scalar>&,           \
                                             const std::array<Vector3<Scalar>, 2>&); \
  template std::optional<Eigensystem2<Scalar>> real_eigensystem(const Matrix2<Scalar>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
