// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// A symmetric 3x3 tensor. Component order everywhere: xx, yy, zz, xy, yz, xz (tensor
/// components; shears carry no factor 2).
template <class Scalar>
struct SymmetricTensor {
  /// The components; those off the diagonal without a factor 2.
  Scalar xx{}, yy{}, zz{}, xy{}, yz{}, xz{};

  /// Component by component.
  friend constexpr SymmetricTensor operator+(const SymmetricTensor& s, const SymmetricTensor& t) {
    return {s.xx + t.xx, s.yy + t.yy, s.zz + t.zz, s.xy + t.xy, s.yz + t.yz, s.xz + t.xz};
  }
  /// Component by component.
  friend constexpr SymmetricTensor operator-(const SymmetricTensor& s, const SymmetricTensor& t) {
    return {s.xx - t.xx, s.yy - t.yy, s.zz - t.zz, s.xy - t.xy, s.yz - t.yz, s.xz - t.xz};
  }
  /// Component by component.
  friend constexpr SymmetricTensor operator*(const Scalar& k, const SymmetricTensor& t) {
    return {k * t.xx, k * t.yy, k * t.zz, k * t.xy, k * t.yz, k * t.xz};
  }
  /// Component by component.
  friend bool operator==(const SymmetricTensor&, const SymmetricTensor&) = default;

  /// The tensor applied to a vector.
  friend constexpr Vector3<Scalar> operator*(const SymmetricTensor& t, const Vector3<Scalar>& v) {
    return {t.xx * v.x + t.xy * v.y + t.xz * v.z, t.xy * v.x + t.yy * v.y + t.yz * v.z,
            t.xz * v.x + t.yz * v.y + t.zz * v.z};
  }
};

/// The tensor in another scalar, component by component.
template <class To, class From>
constexpr SymmetricTensor<To> tensor_cast(const SymmetricTensor<From>& t) {
  return {To(t.xx), To(t.yy), To(t.zz), To(t.xy), To(t.yz), To(t.xz)};
}

/// The largest absolute value of a component.
template <class Scalar>
Scalar max_norm(const SymmetricTensor<Scalar>& t) {
  using std::abs;
  Scalar largest(0);
  for (const Scalar& x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
    if (abs(x) > largest) largest = abs(x);
  return largest;
}

template <class Scalar>
constexpr Scalar trace(const SymmetricTensor<Scalar>& t) {
  return t.xx + t.yy + t.zz;
}

template <class Scalar>
constexpr Scalar determinant(const SymmetricTensor<Scalar>& t) {
  return t.xx * (t.yy * t.zz - t.yz * t.yz) - t.xy * (t.xy * t.zz - t.yz * t.xz) +
         t.xz * (t.xy * t.yz - t.yy * t.xz);
}

/// Inner product <S, T> = trace(S^T T) (the paper's "magnitude" is the root of <T, T>).
template <class Scalar>
constexpr Scalar inner(const SymmetricTensor<Scalar>& s, const SymmetricTensor<Scalar>& t) {
  return s.xx * t.xx + s.yy * t.yy + s.zz * t.zz +
         Scalar(2) * (s.xy * t.xy + s.yz * t.yz + s.xz * t.xz);
}

/// The square T^2 of a symmetric tensor.
template <class Scalar>
constexpr SymmetricTensor<Scalar> square(const SymmetricTensor<Scalar>& t) {
  return {t.xx * t.xx + t.xy * t.xy + t.xz * t.xz, t.xy * t.xy + t.yy * t.yy + t.yz * t.yz,
          t.xz * t.xz + t.yz * t.yz + t.zz * t.zz, t.xx * t.xy + t.xy * t.yy + t.xz * t.yz,
          t.xy * t.xz + t.yy * t.yz + t.yz * t.zz, t.xx * t.xz + t.xy * t.yz + t.xz * t.zz};
}

}  // namespace tensortopo
