// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/tensor/mode_parameter.hpp"

#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/nearest.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

/// The fields that depend on s and cos^2(theta) only.
template <class Scalar>
void complete(ModeParameter<Scalar>& m) {
  using elementary::atan2;
  using std::sqrt;
  m.theta = atan2(m.s, Scalar(sqrt(m.cos_theta_squared)));
  const Scalar norm = sqrt(Scalar(18) + Scalar(6) * m.s_squared);
  m.eigenvalues = {(Scalar(3) + m.s) / norm, -(m.s + m.s) / norm, (m.s - Scalar(3)) / norm};
}

}  // namespace

template <RealScalar Scalar>
ModeParameter<Scalar> mode_parameter(const ModeValue& mode) {
  using elementary::atan2;
  using elementary::cos;
  using elementary::tan;
  using std::sqrt;
  const Rational exact = to_scalar<Rational>(mode);
  ModeParameter<Scalar> m;
  m.mu = nearest<Scalar>(exact);
  m.sign = mode.sign();
  m.abs_mu = m.sign < 0 ? Scalar(-m.mu) : m.mu;
  m.mu_squared = nearest<Scalar>(Rational(exact * exact));
  const Scalar cosine = sqrt(nearest<Scalar>(Rational(1 - exact * exact)));
  const Scalar third_angle = atan2(m.abs_mu, cosine) / Scalar(3);
  const Scalar c = cos(third_angle);
  m.cos_theta_squared = cosine / (c * c * c);
  // At |mu| = 1 the tangent may be rounded above its limit.
  m.s = clamped(Scalar(sqrt(Scalar(3)) * tan(third_angle)), Scalar(0), Scalar(1));
  m.s_squared = m.s * m.s;
  m.one_minus_s = m.cos_theta_squared / (Scalar(1) + m.s);
  complete(m);
  return m;
}

template <RealScalar Scalar>
ModeParameter<Scalar> mode_parameter_from_s(const Scalar& s, int sign) {
  using elementary::atan2;
  using std::sqrt;
  const Scalar one(1);
  ModeParameter<Scalar> m;
  m.s = s;
  m.sign = s == Scalar(0) ? 0 : sign;
  m.s_squared = s * s;
  m.mu_squared = mode_squared_from_s2(m.s_squared);
  m.abs_mu = sqrt(m.mu_squared);
  m.mu = m.sign < 0 ? Scalar(-m.abs_mu) : m.abs_mu;
  m.one_minus_s = one - s;
  m.cos_theta_squared = m.one_minus_s * (one + s);
  complete(m);
  return m;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                     \
  template ModeParameter<Scalar> mode_parameter<Scalar>(const ModeValue&); \
  template ModeParameter<Scalar> mode_parameter_from_s<Scalar>(const Scalar&, int);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
