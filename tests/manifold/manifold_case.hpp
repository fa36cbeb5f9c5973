// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck/gtest.h>

#include <optional>

#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

/// Tolerance of the identities below at 50 digits: ten digits for conditioning.
inline const Real50& tiny() {
  static const Real50 value("1e-40");
  return value;
}

template <class Scalar>
Vector3<Scalar> unit_vector(const Scalar& x, const Scalar& y, const Scalar& z) {
  using std::sqrt;
  const Scalar norm = sqrt(x * x + y * y + z * z);
  return {x / norm, y / norm, z / norm};
}

inline Vector3<Real50> random_unit_vector() {
  int c[3];
  for (int& x : c) x = *rc::gen::inRange(-1000, 1001);
  RC_PRE(c[0] != 0 || c[1] != 0 || c[2] != 0);
  return unit_vector<Real50>(c[0], c[1], c[2]);
}

inline TetrahedronField<Real50> random_integer_field() {
  TetrahedronField<Real50> field;
  for (auto& d : field.vertex)
    for (Real50* x : {&d.a, &d.b, &d.xy, &d.yz, &d.xz}) *x = Real50(*rc::gen::inRange(-9, 10));
  return field;
}

inline ModeValue random_mode() {
  return ModeValue::parse(
      *rc::gen::element<std::string>("1e-9", "0.05", "0.3", "1/2", "-0.7", "0.9", "0.9998", "-1"));
}

/// A random field of rank 4 with its manifold. A field whose characteristic tensor is neutral or
/// degenerate is legal too, and occurs.
struct ManifoldCase {
  TetrahedronField<Real50> field = random_integer_field();
  ModeParameter<Real50> mode = mode_parameter<Real50>(random_mode());
  std::optional<CharacteristicTensor<Real50>> characteristic = characteristic_tensor(field);

  MediumEigenvectorManifold<Real50> manifold() const {
    RC_PRE(characteristic.has_value());
    return {*characteristic, mode};
  }
};

template <class Scalar>
Scalar norm(const SymmetricTensor<Scalar>& t) {
  using std::sqrt;
  return sqrt(inner(t, t));
}

template <class Scalar>
Scalar norm(const Vector3<Scalar>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

}  // namespace tensortopo
