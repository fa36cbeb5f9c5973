// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Two precisions do not meet by accident: the conversion is written out.
// Expect: conflicting types|deduced conflicting
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/vector3.hpp"

using tensortopo::Real50;
using tensortopo::Vector3;

Real50 product(const Vector3<double>& u, const Vector3<Real50>& v) {
#ifdef MUST_NOT_COMPILE
  return tensortopo::dot(u, v);
#else
  return tensortopo::dot(Vector3<Real50>{Real50(u.x), Real50(u.y), Real50(u.z)}, v);
#endif
}
