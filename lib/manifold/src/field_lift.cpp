// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/manifold/field_lift.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
using Vector5 = std::array<Scalar, 5>;

template <class Scalar>
Scalar dot5(const Vector5<Scalar>& x, const Vector5<Scalar>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3] + x[4] * y[4];
}

}  // namespace

template <RealScalar Scalar>
FieldLift<Scalar>::FieldLift(const TetrahedronField<Scalar>& field) {
  if (!build(field))
    throw std::invalid_argument("the vertex deviators of the field are linearly dependent");
}

template <RealScalar Scalar>
std::optional<FieldLift<Scalar>> FieldLift<Scalar>::of(const TetrahedronField<Scalar>& field) {
  FieldLift lift;
  if (!lift.build(field)) return std::nullopt;
  return lift;
}

template <RealScalar Scalar>
bool FieldLift<Scalar>::build(const TetrahedronField<Scalar>& field) {
  using std::sqrt;
  // Modified Gram-Schmidt, twice, in the order of the vertices: T_i = sum over j <= i of r[j][i]
  // q_j. The dual tensors lie in the span of the field, so they are combinations of the q_j with
  // the rows of the inverse of r.
  std::array<Vector5<Scalar>, 4> q{};
  std::array<std::array<Scalar, 4>, 4> r{};
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = orthonormal_coordinates(field.vertex[i]);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t j = 0; j < i; ++j) {
        const Scalar k = dot5(q[i], q[j]);
        r[j][i] = r[j][i] + k;
        for (std::size_t n = 0; n < 5; ++n) q[i][n] = q[i][n] - k * q[j][n];
      }
    r[i][i] = sqrt(dot5(q[i], q[i]));
    if (!(r[i][i] > Scalar(0))) return false;
    for (std::size_t n = 0; n < 5; ++n) q[i][n] = q[i][n] / r[i][i];
  }
  for (std::size_t i = 4; i-- > 0;) {
    Vector5<Scalar> d = q[i];
    for (std::size_t j = i + 1; j < 4; ++j)
      for (std::size_t n = 0; n < 5; ++n) d[n] = d[n] - r[i][j] * dual_[j][n];
    for (std::size_t n = 0; n < 5; ++n) dual_[i][n] = d[n] / r[i][i];
  }
  return true;
}

template <RealScalar Scalar>
std::array<Scalar, 4> FieldLift<Scalar>::weights(const Deviator<Scalar>& t) const {
  const Vector5<Scalar> x = orthonormal_coordinates(t);
  return {dot5(dual_[0], x), dot5(dual_[1], x), dot5(dual_[2], x), dot5(dual_[3], x)};
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class FieldLift<Scalar>;
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
