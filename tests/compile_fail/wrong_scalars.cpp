// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Two precisions do not meet by accident: the conversion is written out. Enclosures have no order,
// so an algorithm that compares values does not take them. The parameter s of a mode is a root:
// rationals do not hold it.
// Expect: (conflicting types|deduced conflicting).*(RealScalar|constraints not satisfied)
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/vector3.hpp"

using tensortopo::Real50;
using tensortopo::Vector3;

#ifdef MUST_NOT_COMPILE
using Enclosure = tensortopo::Interval;
using Exact = tensortopo::Rational;
Real50 product(const Vector3<double>& u, const Vector3<Real50>& v) {
  return tensortopo::dot(u, v);  // refused
}
#else
using Enclosure = double;
using Exact = double;
Real50 product(const Vector3<double>& u, const Vector3<Real50>& v) {
  return tensortopo::dot(Vector3<Real50>{Real50(u.x), Real50(u.y), Real50(u.z)}, v);
}
#endif

Enclosure mode_of(const tensortopo::Deviator<Enclosure>& deviator) {
  return tensortopo::mode(deviator);  // refused
}

Exact s_of(const tensortopo::ModeValue& mode) {
  return tensortopo::mode_parameter<Exact>(mode).s;  // refused
}
