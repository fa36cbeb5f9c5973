// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/pencil.hpp"

namespace tensortopo::theory {
namespace {

bool is_zero(const IntegerTensor& t) { return t == IntegerTensor{}; }

Integer squared(const Integer& x) { return x * x; }

// N at the zero of a polynomial of degree one.
IntegerTensor normal_at(const Polynomial& linear, const std::array<IntegerTensor, 2>& basis) {
  return -linear.coefficient(0) * basis[0] + linear.coefficient(1) * basis[1];
}

}  // namespace

IntegerTensor neutral_companion(const Vector3<Integer>& e, const IntegerTensor& other) {
  const Integer size = dot(e, e), zero(0);
  const IntegerTensor across = {size - e.x * e.x, size - e.y * e.y, size - e.z * e.z,
                                -e.x * e.y,       -e.y * e.z,       -e.x * e.z};
  const std::array<Vector3<Integer>, 3> unit = {
      {{Integer(1), zero, zero}, {zero, Integer(1), zero}, {zero, zero, Integer(1)}}};
  const auto image = [&](std::size_t i) { return across * (other * (across * unit[i])); };
  const Integer part = image(0).x + image(1).y + image(2).z;
  const auto column = [&](std::size_t i) {
    return cross(e, Integer(2) * size * image(i) - part * (across * unit[i]));
  };
  const Vector3<Integer> x = column(0), y = column(1), z = column(2);
  return {x.x, y.y, z.z, x.y, y.z, x.z};
}

Vector3<Integer> dominant_direction(const IntegerTensor& n) {
  const Integer size = inner(n, n), shift = Integer(3) * determinant(n);
  const Integer zero(0);
  const IntegerTensor rank_one = size * n + IntegerTensor{shift, shift, shift, zero, zero, zero};
  if (rank_one.xx != 0) return {rank_one.xx, rank_one.xy, rank_one.xz};
  if (rank_one.yy != 0) return {rank_one.xy, rank_one.yy, rank_one.yz};
  return {rank_one.xz, rank_one.yz, rank_one.zz};
}

PencilSystem pencil_system(const Plane& plane) {
  PencilSystem system;
  system.position = Position::not_isolated;
  // A cubic that is not zero has at most three zeros.
  for (int j = 0; j < 4 && system.position == Position::not_isolated; ++j) {
    system.basis = {plane.complement[0] + Integer(j) * plane.complement[1], plane.complement[1]};
    system.cubic = pencil_cubic(system.normal(), lifted<Polynomial>(system.basis[0]),
                                lifted<Polynomial>(system.basis[1]));
    if (system.cubic.degree() == 3) system.position = Position::general;
  }
  if (system.position == Position::not_isolated) return system;
  if (!is_squarefree(system.cubic)) {
    system.position = Position::coincident;
    return system;
  }
  const auto normal = system.normal();
  const Polynomial degenerate =
      greatest_common_divisor(system.cubic, degeneracy_form(normal));
  system.regular = {quotient(system.cubic, degenerate), primitive(coordinates(plane, companion(normal)))};
  if (degenerate.degree() == 1) {
    const IntegerTensor n = normal_at(degenerate, system.basis);
    const IntegerTensor t = neutral_companion(dominant_direction(n), system.basis[0]);
    const IntegerTensor u = neutral_companion(dominant_direction(n), system.basis[1]);
    system.neutral.push_back(is_zero(t) ? u : t);
  } else if (degenerate.degree() > 1) {
    system.position = Position::degenerate_normals;
  }
  return system;
}

std::vector<CriticalKind> real_points(const Plane& plane, const PencilSystem& pencil) {
  std::vector<CriticalKind> points = real_points(plane, pencil.regular);
  const auto sign = [](const Integer& x) { return static_cast<Sign>(x.sign()); };
  for (const IntegerTensor& t : pencil.neutral) {
    const Vector3<Integer> weights = coordinates(plane, t);
    points.push_back({sign(morse_form(plane.basis, t)), sign(degeneracy_form(t)),
                      sign(weights.x + weights.y + weights.z)});
  }
  return points;
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
