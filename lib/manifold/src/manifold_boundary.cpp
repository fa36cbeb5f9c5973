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
  return sphere_point(Scalar(sin(theta)), Scalar(cos(theta)), Scalar(sin(eta)), Scalar(cos(eta)));
}

template <RealScalar Scalar>
Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(const Scalar& st, const Scalar& ct,
                                                                const Scalar& se,
                                                                const Scalar& ce) const {
  using std::sqrt;
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
SpheroConal<Scalar> MediumEigenvectorManifold<Scalar>::sphero_conal(
    const Vector3<Scalar>& v) const {
  using elementary::atan2;
  using std::sqrt;
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
  SpheroConal<Scalar> result;
  result.theta = atan2(with_sign(sin2_theta, w.y), with_sign(cos2_theta, w.x));
  if (result.theta < zero) result.theta = result.theta + two * pi<Scalar>();
  // A tiny negative angle may be rounded to the full turn.
  if (result.theta >= two * pi<Scalar>()) result.theta = zero;
  result.eta = atan2(root_of_nonnegative(sin2_eta), with_sign(cos2_eta, w.z));
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
  using elementary::asin;
  using elementary::cos;
  using elementary::sin;
  using std::sqrt;
  const Scalar zero(0), one(1), two(2);
  if (single_loop()) {
    // c - p sin^2 = (c - p) + p cos^2: nothing cancels.
    const Scalar numerator = (c_ - p_) + p_ * squared(Scalar(cos(phi)));
    return sphere_point(phi, asin(clamped(Scalar(sqrt(numerator / q_)), zero, one)));
  }
  const Scalar half = phi / two;
  // p = 0 leaves no oval but a point: then c = 0 too.
  const Scalar ratio = p_ > zero ? Scalar(sqrt(c_ / p_)) : zero;
  const Scalar offset = asin(clamped(Scalar(ratio * cos(half)), Scalar(-1), one));
  const Scalar eta = asin(Scalar(sqrt(c_ / q_) * sin(half)));
  return sphere_point(loop == 0 ? offset : Scalar(pi<Scalar>() + offset), eta);
}

template <RealScalar Scalar>
BoundaryPosition<Scalar> MediumEigenvectorManifold<Scalar>::boundary_position(
    const Vector3<Scalar>& v) const {
  using elementary::atan2;
  using elementary::sin;
  using std::sqrt;
  const Scalar zero(0), two(2);
  BoundaryPosition<Scalar> position;
  position.sign = dot(characteristic_.eigenvectors[2], v) < zero ? -1 : 1;
  const Vector3<Scalar> up = position.sign < 0 ? -v : v;
  const SpheroConal<Scalar> at = sphero_conal(up);
  if (single_loop()) {
    position.phi = at.theta;
    return position;
  }
  position.loop = dot(characteristic_.eigenvectors[0], up) < zero ? 1 : 0;
  const Scalar sine = position.loop == 0 ? Scalar(sin(at.theta)) : Scalar(-sin(at.theta));
  // eta >= 0, so this is in [0, 2 pi].
  position.phi = two * atan2(Scalar(sqrt(q_) * sin(at.eta)), Scalar(sqrt(p_) * sine));
  if (position.phi >= two * pi<Scalar>()) position.phi = zero;
  return position;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::in_frame(const Vector3<Scalar>&)   \
      const;                                                                                     \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(                      \
      const Scalar&, const Scalar&, const Scalar&, const Scalar&) const;                         \
  template Vector3<Scalar> MediumEigenvectorManifold<Scalar>::sphere_point(const Scalar&,        \
                                                                           const Scalar&) const; \
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
