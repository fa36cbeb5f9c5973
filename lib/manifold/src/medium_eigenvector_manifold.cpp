// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

#include <cmath>

#include "tangents.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <RealScalar Scalar>
MediumEigenvectorManifold<Scalar>::MediumEigenvectorManifold(
    const CharacteristicTensor<Scalar>& characteristic, const ModeParameter<Scalar>& mode)
    : characteristic_(characteristic), mode_(mode) {
  using std::sqrt;
  const auto& [b1, b2, b3] = characteristic_.eigenvalues;
  const auto& [e1, e2, e3] = characteristic_.eigenvectors;
  A_ = sqrt((b1 - b2) / (b1 - b3));
  B_ = sqrt((b2 - b3) / (b1 - b3));
  singularities_ = {A_ * e1 + B_ * e3, B_ * e3 - A_ * e1};
  p_ = mode_.one_minus_s * (b1 - b2);
  q_ = (Scalar(1) + mode_.s) * (b2 - b3);
  c_ = Scalar(2) * mode_.s * b2;
}

template <RealScalar Scalar>
auto MediumEigenvectorManifold<Scalar>::tangents(const Vector3<Scalar>& v) const -> Tangents {
  using std::sqrt;
  const auto& [b1, b2, b3] = characteristic_.eigenvalues;
  Tangents t;
  t.first = across(singularities_[0], v);
  t.second = across(singularities_[1], v);
  t.half_gap = (b1 - b3) / Scalar(2);
  t.product = sqrt(dot(t.first, t.first) * dot(t.second, t.second));
  // v.T v = b2 - (b1 - b3)(s1.v)(s2.v).
  t.alpha = b2 - (t.half_gap + t.half_gap) * dot(singularities_[0], v) * dot(singularities_[1], v);
  return t;
}

template <RealScalar Scalar>
Scalar MediumEigenvectorManifold<Scalar>::boundary_function(const Vector3<Scalar>& v) const {
  const Tangents t = tangents(v);
  // Half of d+ - d-, and half of s (d+ + d-).
  const Scalar half_difference = t.half_gap * t.product;
  const Scalar half_sum = mode_.s * t.alpha / Scalar(2);
  return (half_difference + half_sum) * (half_difference - half_sum);
}

template <RealScalar Scalar>
bool MediumEigenvectorManifold<Scalar>::in_real_domain(const Vector3<Scalar>& v) const {
  return boundary_function(v) >= Scalar(0);
}

/// (l2) v v^T - (l2 / 2) P + ((l1 - l3) / 2) (cosine N + sine [v]x N), where N is the unit
/// traceless part of the characteristic tensor restricted to the plane across v: N = (a1.a2) P - a1
/// a2^T - a2 a1^T for the unit tangents a1, a2 towards the singularities.
template <RealScalar Scalar>
SymmetricTensor<Scalar> MediumEigenvectorManifold<Scalar>::assemble(const Vector3<Scalar>& v,
                                                                    const Tangents& t,
                                                                    const Scalar& cosine,
                                                                    const Scalar& sine) const {
  const auto& [l1, l2, l3] = mode_.eigenvalues;
  const Vector3<Scalar>& first = t.first;
  const Vector3<Scalar> turned = cross(v, first);
  // [v]x N turns N by a quarter: it replaces a1 by v x a1 while a2 stays, the two being
  // symmetrised.
  const Scalar scale = (l1 - l3) / (Scalar(2) * t.product);
  const Vector3<Scalar> a = Scalar(-scale * cosine) * first + Scalar(-scale * sine) * turned;
  const Vector3<Scalar>& b = t.second;
  const Scalar half(Scalar(1) / Scalar(2));
  const Scalar isotropic = -half * l2 - dot(a, b);
  const Scalar axial = l2 - isotropic;
  const Scalar two(2);
  return {isotropic + axial * v.x * v.x + two * a.x * b.x,
          isotropic + axial * v.y * v.y + two * a.y * b.y,
          isotropic + axial * v.z * v.z + two * a.z * b.z,
          axial * v.x * v.y + a.x * b.y + a.y * b.x,
          axial * v.y * v.z + a.y * b.z + a.z * b.y,
          axial * v.x * v.z + a.x * b.z + a.z * b.x};
}

template <RealScalar Scalar>
SymmetricTensor<Scalar> MediumEigenvectorManifold<Scalar>::tensor_at(
    const Vector3<Scalar>& v) const {
  using std::sqrt;
  const Tangents t = tangents(v);
  const Scalar half_difference = t.half_gap * t.product;
  const Scalar half_sum = mode_.s * t.alpha / Scalar(2);
  const Scalar delta = (half_difference + half_sum) * (half_difference - half_sum);
  if (!(delta > Scalar(0))) return tensor_at_boundary(v);
  return assemble(v, t, half_sum / half_difference, sqrt(delta) / half_difference);
}

template <RealScalar Scalar>
SymmetricTensor<Scalar> MediumEigenvectorManifold<Scalar>::tensor_at_boundary(
    const Vector3<Scalar>& v) const {
  // There d+ >= d- >= 0 and their sum is -alpha, so the cosine is -1.
  return assemble(v, tangents(v), Scalar(-1), Scalar(0));
}

template <RealScalar Scalar>
Scalar MediumEigenvectorManifold<Scalar>::sigma(const Vector3<Scalar>& v,
                                                const Vector3<Scalar>& d) const {
  const Tangents t = tangents(v);
  const Vector3<Scalar> w = cross(v, d);
  return -t.half_gap * (dot(t.first, d) * dot(t.second, w) + dot(t.second, d) * dot(t.first, w));
}

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::dominant_eigenvector(
    const Vector3<Scalar>& v) const {
  using std::abs;
  using std::sqrt;
  const Tangents t = tangents(v);
  const Scalar half_difference = t.half_gap * t.product;
  const Scalar half_sum = mode_.s * t.alpha / Scalar(2);
  const Scalar delta = (half_difference + half_sum) * (half_difference - half_sum);
  const bool inside = delta > Scalar(0);
  const std::array<Scalar, 2> turn = {inside ? half_sum : Scalar(-half_difference),
                                      inside ? Scalar(sqrt(delta)) : Scalar(0)};
  // In the plane, with angles counterclockwise about v: N has its major axis across the bisector of
  // the tangents, so at (angle1 + angle2) / 2 + pi / 2; turning N by the angle of `turn` turns the
  // axis by half of it. With e1 at angle 0, (x, y) is at twice the bisector's angle so turned.
  const Vector3<Scalar> e1 = unit(t.first);
  const Vector3<Scalar> e2 = cross(v, e1);
  const Scalar along = dot(t.second, e1), across = dot(t.second, e2);
  const Scalar x = along * turn[0] - across * turn[1], y = along * turn[1] + across * turn[0];
  const Scalar radius = sqrt(x * x + y * y);
  // The sum in which nothing cancels is the larger of the half angle's coordinates.
  const Scalar larger = radius + abs(x);
  if (!(larger > Scalar(0))) return e1;  // at a singularity all directions are
  return unit(x < Scalar(0) ? larger * e1 - y * e2 : larger * e2 - y * e1);
}

template <RealScalar Scalar>
std::array<Scalar, 2> MediumEigenvectorManifold<Scalar>::plane_eigenvalues(
    const Vector3<Scalar>& v) const {
  const Tangents t = tangents(v);
  const Scalar half_difference = t.half_gap * t.product, mean = -t.alpha / Scalar(2);
  return {mean + half_difference, mean - half_difference};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template MediumEigenvectorManifold<Scalar>::MediumEigenvectorManifold(                         \
      const CharacteristicTensor<Scalar>&, const ModeParameter<Scalar>&);                        \
  template Scalar MediumEigenvectorManifold<Scalar>::boundary_function(const Vector3<Scalar>&)   \
      const;                                                                                     \
  template bool MediumEigenvectorManifold<Scalar>::in_real_domain(const Vector3<Scalar>&) const; \
  template SymmetricTensor<Scalar> MediumEigenvectorManifold<Scalar>::tensor_at(                 \
      const Vector3<Scalar>&) const;                                                             \
  template SymmetricTensor<Scalar> MediumEigenvectorManifold<Scalar>::tensor_at_boundary(        \
      const Vector3<Scalar>&) const;                                                             \
  template Scalar MediumEigenvectorManifold<Scalar>::sigma(const Vector3<Scalar>&,               \
                                                           const Vector3<Scalar>&) const;        \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::dominant_eigenvector(              \
      const Vector3<Scalar>&) const;                                                             \
  template std::array<Scalar, 2> MediumEigenvectorManifold<Scalar>::plane_eigenvalues(           \
      const Vector3<Scalar>&) const;
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
