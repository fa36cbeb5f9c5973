// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tangents.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::in_frame(const Vector3<Scalar>& v) const {
  const auto& [e1, e2, e3] = characteristic_.eigenvectors;
  return {dot(e1, v), dot(e2, v), dot(e3, v)};
}

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(const Scalar& theta,
                                                                const Scalar& eta) const {
  using elementary::cos;
  using elementary::sin;
  return sphere_point({sin(theta), cos(theta), sin(eta), cos(eta)});
}

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(
    const SpheroConalSines<Scalar>& at) const {
  using std::sqrt;
  const auto& [st, ct, se, ce] = at;
  // 1 - B^2 cos^2 = A^2 + B^2 sin^2, as A^2 + B^2 = 1.
  const Scalar x = ct * sqrt(squared(A_) + squared(Scalar(B_ * se)));
  const Scalar y = st * se;
  const Scalar z = ce * sqrt(squared(B_) + squared(Scalar(A_ * st)));
  const auto& [e1, e2, e3] = characteristic_.eigenvectors;
  return x * e1 + y * e2 + z * e3;
}

namespace {

/// The root of k u^2 + g u - h = 0 (k, h >= 0) that is not negative, given R = sqrt(g^2 + 4 k h).
template <class Scalar>
Scalar nonnegative_root(const Scalar& k, const Scalar& g, const Scalar& h, const Scalar& R) {
  if (g >= Scalar(0)) {
    const Scalar denominator = g + R;
    return denominator > Scalar(0) ? Scalar((h + h) / denominator) : Scalar(0);
  }
  return (R - g) / (k + k);
}

}  // namespace

template <RealScalar Scalar>
SpheroConalSines<Scalar> MediumEigenvectorManifold<Scalar>::sphero_conal_sines(
    const Vector3<Scalar>& v) const {
  const Vector3<Scalar> w = in_frame(v);
  const Scalar zero(0), one(1), two(2);
  const Scalar x2 = w.x * w.x, y2 = w.y * w.y, z2 = w.z * w.z;
  const Scalar A2 = A_ * A_, B2 = B_ * B_;
  // sin(angle to s1) sin(angle to s2) is the discriminant's root of all four quadratics below.
  const Scalar R = tangents(v).product;
  const Scalar sin2_theta = nonnegative_root(A2, Scalar(x2 + B2 * y2 - A2), Scalar(B2 * y2), R);
  const Scalar sin2_eta = nonnegative_root(B2, Scalar(z2 + A2 * y2 - B2), Scalar(A2 * y2), R);
  const Scalar theta_sum = x2 * (one + A2) + y2 + A2 * z2 + R;
  const Scalar eta_sum = z2 * (one + B2) + y2 + B2 * x2 + R;
  const Scalar cos2_theta = theta_sum > zero ? Scalar(two * x2 / theta_sum) : zero;
  const Scalar cos2_eta = eta_sum > zero ? Scalar(two * z2 / eta_sum) : zero;
  const auto with_sign = [&](const Scalar& square, const Scalar& like) {
    const Scalar root = root_of_nonnegative(square);
    return like < zero ? Scalar(-root) : root;
  };
  return {with_sign(sin2_theta, w.y), with_sign(cos2_theta, w.x), root_of_nonnegative(sin2_eta),
          with_sign(cos2_eta, w.z)};
}

template <RealScalar Scalar>
SpheroConal<Scalar> MediumEigenvectorManifold<Scalar>::sphero_conal(
    const Vector3<Scalar>& v) const {
  using elementary::atan2;
  const SpheroConalSines<Scalar> at = sphero_conal_sines(v);
  const Scalar zero(0), two(2);
  SpheroConal<Scalar> result;
  result.theta = atan2(at.sin_theta, at.cos_theta);
  if (result.theta < zero) result.theta = result.theta + two * pi<Scalar>();
  // A tiny negative angle may be rounded to the full turn.
  if (result.theta >= two * pi<Scalar>()) result.theta = zero;
  result.eta = atan2(at.sin_eta, at.cos_eta);
  return result;
}

template <RealScalar Scalar>
Scalar MediumEigenvectorManifold<Scalar>::F(const Scalar& theta, const Scalar& eta) const {
  using elementary::sin;
  return p_ * squared(Scalar(sin(theta))) + q_ * squared(Scalar(sin(eta))) - c_;
}

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::boundary_point(int loop,
                                                                  const Scalar& phi) const {
  using elementary::cos;
  using elementary::sin;
  using std::sqrt;
  const Scalar zero(0), one(1), two(2);
  if (single_loop()) {
    const Scalar sine = sin(phi), cosine = cos(phi);
    // q sin^2 eta = c - p sin^2 theta and q cos^2 eta, as sums in which nothing cancels.
    return sphere_point({sine, cosine, sqrt(Scalar(((c_ - p_) + p_ * squared(cosine)) / q_)),
                         sqrt(Scalar(((q_ - c_) + p_ * squared(sine)) / q_))});
  }
  const Scalar half = phi / two;
  // p = 0 leaves no oval but a point: then c = 0 too.
  const Scalar ratio = p_ > zero ? Scalar(sqrt(c_ / p_)) : zero;
  const auto cosine_of = [&](const Scalar& sine) {
    return root_of_nonnegative(Scalar((one - sine) * (one + sine)));
  };
  const Scalar sin_theta = clamped(Scalar(ratio * cos(half)), Scalar(-1), one);
  const Scalar sin_eta = sqrt(c_ / q_) * sin(half);
  const Scalar side(loop == 0 ? 1 : -1);  // the other oval is half a turn away
  return sphere_point(
      {Scalar(side * sin_theta), Scalar(side * cosine_of(sin_theta)), sin_eta, cosine_of(sin_eta)});
}

template <RealScalar Scalar>
BoundaryPosition<Scalar> MediumEigenvectorManifold<Scalar>::boundary_position(
    const Vector3<Scalar>& v) const {
  using elementary::atan2;
  using std::sqrt;
  const Scalar zero(0), two(2);
  BoundaryPosition<Scalar> position;
  position.sign = dot(characteristic_.eigenvectors[2], v) < zero ? -1 : 1;
  const Vector3<Scalar> up = position.sign < 0 ? -v : v;
  if (single_loop()) {
    position.phi = sphero_conal(up).theta;
    return position;
  }
  const SpheroConalSines<Scalar> at = sphero_conal_sines(up);
  position.loop = dot(characteristic_.eigenvectors[0], up) < zero ? 1 : 0;
  const Scalar sine = position.loop == 0 ? at.sin_theta : Scalar(-at.sin_theta);
  // eta >= 0, so this is in [0, 2 pi].
  position.phi = two * atan2(Scalar(sqrt(q_) * at.sin_eta), Scalar(sqrt(p_) * sine));
  if (position.phi >= two * pi<Scalar>()) position.phi = zero;
  return position;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::in_frame(const Vector3<Scalar>&)   \
      const;                                                                                     \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(                      \
      const SpheroConalSines<Scalar>&) const;                                                    \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(const Scalar&,        \
                                                                           const Scalar&) const; \
  template SpheroConalSines<Scalar> MediumEigenvectorManifold<Scalar>::sphero_conal_sines(       \
      const Vector3<Scalar>&) const;                                                             \
  template SpheroConal<Scalar> MediumEigenvectorManifold<Scalar>::sphero_conal(                  \
      const Vector3<Scalar>&) const;                                                             \
  template Scalar MediumEigenvectorManifold<Scalar>::F(const Scalar&, const Scalar&) const;      \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::boundary_point(int, const Scalar&) \
      const;                                                                                     \
  template BoundaryPosition<Scalar> MediumEigenvectorManifold<Scalar>::boundary_position(        \
      const Vector3<Scalar>&) const;
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
