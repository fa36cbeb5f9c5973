// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/plane.hpp"

#include <vector>

#include "complement.hpp"

namespace tensortopo::theory {
namespace {

std::array<Rational*, 5> entries(Deviator<Rational>& d) {
  return {&d.a, &d.b, &d.xy, &d.yz, &d.xz};
}

// A positive number that makes the entries of all these integers.
Integer common_denominator(std::vector<Deviator<Rational>> all) {
  Integer common(1);
  for (Deviator<Rational>& d : all) {
    for (const Rational* entry : entries(d)) common = lcm(common, Integer(denominator(*entry)));
  }
  return common;
}

IntegerTensor integral(const Deviator<Rational>& d, const Integer& factor) {
  const auto t = Rational(factor) * thrice(d);
  const auto whole = [](const Rational& x) { return Integer(numerator(x)); };
  return {whole(t.xx), whole(t.yy), whole(t.zz), whole(t.xy), whole(t.yz), whole(t.xz)};
}

}  // namespace

std::optional<Plane> plane_of(const TriangleField<Rational>& field) {
  const auto& d = field.vertex;
  const Tensor tensors[] = {to_tensor(d[0]), to_tensor(d[1]), to_tensor(d[2])};
  const std::vector<Tensor> normal = orthogonal_complement(tensors);
  if (normal.size() != 2) return std::nullopt;
  Plane plane;
  const Integer factor = common_denominator({d[0], d[1], d[2]});
  for (std::size_t i = 0; i < 3; ++i) plane.basis[i] = integral(d[i], factor);
  for (std::size_t i = 0; i < 2; ++i) {
    const Deviator<Rational> n = deviator(normal[i]);
    plane.complement[i] = integral(n, common_denominator({n}));
  }
  return plane;
}

std::optional<Plane> plane_of(const TetrahedronField<Rational>& field) {
  return plane_of(first_face(field));
}

TriangleField<Rational> first_face(const TetrahedronField<Rational>& field) {
  return {{field.vertex[0], field.vertex[1], field.vertex[2]}};
}

IntegerTensor gram_matrix(const std::array<IntegerTensor, 3>& b) {
  return {inner(b[0], b[0]), inner(b[1], b[1]), inner(b[2], b[2]),
          inner(b[0], b[1]), inner(b[1], b[2]), inner(b[0], b[2])};
}

}  // namespace tensortopo::theory
