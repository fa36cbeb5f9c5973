// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/tensor/eigen_decomposition.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
using Matrix = std::array<std::array<Scalar, 3>, 3>;

/// One Jacobi rotation in the plane (p, q) that makes a[p][q] vanish; the columns of v follow.
template <class Scalar>
void rotate(Matrix<Scalar>& a, Matrix<Scalar>& v, std::size_t p, std::size_t q) {
  using std::abs;
  using std::sqrt;
  if (a[p][q] == Scalar(0)) return;
  const Scalar difference = a[q][q] - a[p][p];
  const Scalar doubled = a[p][q] + a[p][q];
  // t = tan of the smaller angle: root of t^2 + 2 t cot - 1 with cot = difference / doubled.
  const Scalar hypotenuse = sqrt(difference * difference + doubled * doubled);
  if (hypotenuse == Scalar(0)) return;
  const Scalar t = doubled / (difference < Scalar(0) ? Scalar(difference - hypotenuse)
                                                     : Scalar(difference + hypotenuse));
  const Scalar c = Scalar(1) / sqrt(t * t + Scalar(1)), s = t * c;
  const std::size_t r = 3 - p - q;
  const Scalar shift = t * a[p][q];
  a[p][p] = a[p][p] - shift;
  a[q][q] = a[q][q] + shift;
  a[p][q] = a[q][p] = Scalar(0);
  const Scalar arp = a[r][p], arq = a[r][q];
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
  for (std::size_t k = 0; k < 3; ++k) {
    const Scalar vp = v[k][p], vq = v[k][q];
    v[k][p] = c * vp - s * vq;
    v[k][q] = s * vp + c * vq;
  }
}

template <class Scalar>
Vector3<Scalar> with_positive_largest_component(const Vector3<Scalar>& v) {
  using std::abs;
  const Scalar* largest = &v.x;
  if (abs(v.y) > abs(*largest)) largest = &v.y;
  if (abs(v.z) > abs(*largest)) largest = &v.z;
  return *largest < Scalar(0) ? -v : v;
}

}  // namespace

template <RealScalar Scalar>
Eigensystem<Scalar> eigen_decomposition(const SymmetricTensor<Scalar>& tensor) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  const Scalar zero(0), one(1);
  int exponent = 0;
  frexp(max_norm(tensor), &exponent);
  const auto scaled = [&](const Scalar& x) { return Scalar(ldexp(x, -exponent)); };
  const Scalar xy = scaled(tensor.xy), yz = scaled(tensor.yz), xz = scaled(tensor.xz);
  Matrix<Scalar> a = {
      {{scaled(tensor.xx), xy, xz}, {xy, scaled(tensor.yy), yz}, {xz, yz, scaled(tensor.zz)}}};
  Matrix<Scalar> v = {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  // Entries are at most 1 now; convergence is quadratic, so this target costs one sweep more than
  // rounding level and the bound on sweeps is never met.
  const Scalar target = std::numeric_limits<Scalar>::epsilon() / Scalar(64);
  for (int sweep = 0; sweep < 64; ++sweep) {
    if (abs(a[0][1]) + abs(a[1][2]) + abs(a[0][2]) <= target) break;
    rotate(a, v, 0, 1);
    rotate(a, v, 0, 2);
    rotate(a, v, 1, 2);
  }
  std::array<std::size_t, 3> order = {0, 1, 2};
  const auto sort_pair = [&](std::size_t i, std::size_t j) {
    if (a[order[i]][order[i]] < a[order[j]][order[j]]) std::swap(order[i], order[j]);
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  Eigensystem<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = order[i];
    result.values[i] = ldexp(a[k][k], exponent);
    result.vectors[i] = with_positive_largest_component(Vector3<Scalar>{v[0][k], v[1][k], v[2][k]});
  }
  auto& [major, medium, minor] = result.vectors;
  major = unit(major);
  medium = unit(medium - dot(major, medium) * major);
  minor = cross(major, medium);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template Eigensystem<Scalar> eigen_decomposition(const SymmetricTensor<Scalar>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
