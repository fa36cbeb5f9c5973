// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_transitions.hpp"

#include <array>

#include "extract/curves/points/degenerate_forms.hpp"
#include "rational/rational_polynomial.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {

namespace {

using Polynomial = detail::RationalPolynomial;
using PolynomialVector = std::array<Polynomial, 3>;

Vector3<Rational> exact(const Vector3<double>& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

Polynomial form_at(const SymmetricTensor<Rational>& f, const PolynomialVector& e) {
  const auto& [x, y, z] = e;
  return f.xx * x * x + f.yy * y * y + f.zz * z * z +
         Rational(2) * (f.xy * x * y + f.yz * y * z + f.xz * x * z);
}

}  // namespace

std::optional<int> exact_transitions(const TetMesh& mesh, const Vector3<double>& known) {
  std::array<ScaledTensor, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) tensors[i] = {mesh.tensors[i], 0};
  const auto rows = coordinate_rows<Rational>(tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  const auto& conic = forms.across[0];
  if (forms.determinant == 0 || determinant(conic) == 0) return std::nullopt;
  const auto b = exact(known);
  const auto tangent = conic * b;
  if (dot(b, tangent) != 0) return std::nullopt;

  // d = p + s q, and e = (d.N d) b - 2 (b.N d) d is the other point on the line through b and d.
  const Vector3<Rational> p{Rational(3), Rational(-7), Rational(5)},
      q{Rational(-2), Rational(11), Rational(13)};
  if (dot(b, cross(p, q)) == 0) return std::nullopt;
  const PolynomialVector d{Polynomial{p.x, q.x}, Polynomial{p.y, q.y}, Polynomial{p.z, q.z}};
  const Polynomial square = form_at(conic, d);
  const Polynomial mixed = tangent.x * d[0] + tangent.y * d[1] + tangent.z * d[2];
  const PolynomialVector e{b.x * square - Rational(2) * mixed * d[0],
                           b.y * square - Rational(2) * mixed * d[1],
                           b.z * square - Rational(2) * mixed * d[2]};
  std::array<Polynomial, 4> weights;
  Polynomial sum;
  PolynomialVector place;
  for (std::size_t i = 0; i < 4; ++i) {
    weights[i] = form_at(forms.weight[i], e);
    const auto x = exact(mesh.points[i]);
    sum += weights[i];
    place[0] += x.x * weights[i];
    place[1] += x.y * weights[i];
    place[2] += x.z * weights[i];
  }
  Polynomial across;
  for (std::size_t k = 0; k < 3; ++k)
    across += e[k] * (place[k].prime() * sum - place[k] * sum.prime());
  if (across.is_zero()) return std::nullopt;
  // The sum over all products of weights of the sum of their signs at the zeros: 16 for each zero
  // at which all weights are positive.
  int positive = 0, negative = 0;
  for (unsigned chosen = 0; chosen < 16; ++chosen) {
    Polynomial product{Rational(1)};
    int sign = 1;
    for (unsigned i = 0; i < 4; ++i)
      if (chosen >> i & 1) product *= weights[i], sign = -sign;
    const int query = detail::tarski_query(across, product);
    positive += query;
    negative += sign * query;
  }
  if (positive % 16 != 0 || negative % 16 != 0) return std::nullopt;  // a zero on a face
  return (positive + negative) / 16;
}

}  // namespace tensortopo::test
