// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/level.hpp"

#include <utility>

#include "extract/level/level_slope.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

template <class Scalar>
Level<Scalar> make_level(const ModeValue& value) {
  using std::sqrt;
  const auto parameter = mode_parameter<Scalar>(value);
  Level<Scalar> level;
  level.value = value;
  level.sign = value.sign() < 0 ? -1 : 1;
  level.mu = parameter.mu;
  level.mu_squared = parameter.mu_squared;
  level.sqrt2 = sqrt(Scalar(2));
  level.eigenvalues = parameter.eigenvalues;
  if (level.sign < 0) {
    // The tensor of mode -mu is the opposite of one of mode mu.
    std::swap(level.eigenvalues[0], level.eigenvalues[2]);
    for (auto& lambda : level.eigenvalues) lambda = -lambda;
  }
  level.parameter = mode_parameter<double>(value);
  level.lode_angle = elementary::acos(value.approx()) / 3;
  return level;
}

template <class Scalar>
LevelSlope<Scalar> level_slope(const Deviator<Scalar>& t, const Level<Scalar>& level) {
  return detail::slope_at<LevelSlope<Scalar>>(t, level);
}

namespace {

/// Unit kernel vector of a symmetric tensor of rank two: the longest cross product of two rows.
template <class Scalar>
Vector3<Scalar> kernel_vector(const SymmetricTensor<Scalar>& m) {
  using std::sqrt;
  const Vector3<Scalar> r0{m.xx, m.xy, m.xz}, r1{m.xy, m.yy, m.yz}, r2{m.xz, m.yz, m.zz};
  const Vector3<Scalar> c[3] = {cross(r1, r2), cross(r2, r0), cross(r0, r1)};
  int best = 0;
  Scalar length = dot(c[0], c[0]);
  for (int i = 1; i < 3; ++i) {
    const Scalar l = dot(c[i], c[i]);
    if (l > length) best = i, length = l;
  }
  if (!(length > Scalar(0))) return {Scalar(0), Scalar(0), Scalar(1)};
  return (Scalar(1) / sqrt(length)) * c[best];
}

template <class Scalar>
Vector3<Scalar> eigenvector(const Deviator<Scalar>& t, const Scalar& unit_eigenvalue) {
  using std::sqrt;
  auto m = thrice(t);
  const Scalar lambda = sqrt(Scalar(3) * norm_form(t)) * unit_eigenvalue;  // |m| = sqrt(3 P)
  m.xx = m.xx - lambda, m.yy = m.yy - lambda, m.zz = m.zz - lambda;
  return kernel_vector(m);
}

}  // namespace

template <class Scalar>
Vector3<Scalar> medium_eigenvector(const Deviator<Scalar>& t, const Level<Scalar>& level) {
  return eigenvector(t, level.eigenvalues[1]);
}

template <class Scalar>
Vector3<Scalar> dominant_eigenvector(const Deviator<Scalar>& t, const Level<Scalar>& level) {
  return eigenvector(t, level.eigenvalues[level.sign > 0 ? 0 : 2]);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                        \
  template Level<Scalar> make_level<Scalar>(const ModeValue&);                                \
  template LevelSlope<Scalar> level_slope(const Deviator<Scalar>&, const Level<Scalar>&);     \
  template Vector3<Scalar> medium_eigenvector(const Deviator<Scalar>&, const Level<Scalar>&); \
  template Vector3<Scalar> dominant_eigenvector(const Deviator<Scalar>&, const Level<Scalar>&);
TENSORTOPO_FOR_EACH_PRECISION(TENSORTOPO_INSTANTIATE)
TENSORTOPO_INSTANTIATE(Real100)  // for proofs that 50 digits do not settle
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
