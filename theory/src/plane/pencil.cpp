// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/pencil.hpp"

namespace tensortopo::theory {
namespace {

Integer squared(const Integer& x) { return x * x; }

// Whether the weights are not all zero, at each of the parameters.
bool has_points(const PointFamily& family) {
  const auto& w = family.weights;
  const Polynomial common = greatest_common_divisor(greatest_common_divisor(w.x, w.y), w.z);
  return greatest_common_divisor(family.parameters, common).degree() <= 0;
}

// The neutral tensors for the zeros of `degenerate`. A vector that is orthogonal to none of their
// eigenvectors is found among a few.
bool find_neutral(const Plane& plane, const Polynomial& degenerate, PencilSystem& system) {
  const auto normal = system.normal(), other = tensor_cast<Polynomial>(system.basis[0]);
  for (int i = 0; i < 8; ++i) {
    const Vector3<Polynomial> v = {Polynomial(1), Polynomial(i), Polynomial(i * i)};
    const auto t = neutral_companion(dominant_direction(normal, v), other);
    system.neutral = {degenerate, primitive(coordinates(plane, t))};
    if (has_points(system.neutral)) return true;
  }
  return false;
}

}  // namespace

PencilSystem pencil_system(const Plane& plane) {
  PencilSystem system;
  system.position = Position::not_isolated;
  // A cubic that is not zero has at most three zeros.
  for (int j = 0; j < 4 && system.position == Position::not_isolated; ++j) {
    system.basis = {plane.complement[0] + Integer(j) * plane.complement[1], plane.complement[1]};
    system.cubic = pencil_cubic(system.normal(), tensor_cast<Polynomial>(system.basis[0]),
                                tensor_cast<Polynomial>(system.basis[1]));
    if (system.cubic.degree() == 3) system.position = Position::general;
  }
  if (system.position == Position::not_isolated) return system;
  if (!is_squarefree(system.cubic)) {
    system.position = Position::coincident;
    return system;
  }
  const auto normal = system.normal();
  const Polynomial isotropic = greatest_common_divisor(system.cubic, inner(normal, normal));
  const Polynomial rest = quotient(system.cubic, isotropic);
  const Polynomial degenerate = greatest_common_divisor(rest, degeneracy_form(normal));
  system.regular = {quotient(rest, degenerate), primitive(coordinates(plane, companion(normal)))};
  if (isotropic.degree() > 0) system.position = Position::isotropic;
  if (!find_neutral(plane, degenerate, system)) system.position = Position::coincident;
  return system;
}

int neutral_normals(const Plane& plane) {
  const auto& [n1, n2] = plane.complement;
  const IntegerTensor q1 = square(n1), q2 = square(n2);
  const Integer a = inner(q1, n1), b = Integer(3) * inner(q1, n2), c = Integer(3) * inner(q2, n1),
                d = inner(q2, n2);
  const Integer discriminant = squared(b * c) - Integer(4) * (a * c * c * c + b * b * b * d) -
                               Integer(27) * squared(a * d) + Integer(18) * a * b * c * d;
  if (discriminant == 0) return 0;
  return discriminant > 0 ? 3 : 1;
}

}  // namespace tensortopo::theory
