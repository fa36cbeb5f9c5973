// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// A vector of R^3 over any ring. (Eigen would serve for double; exact scalars and enclosures
/// want nothing but + - *, and a client that includes this file should not pay for more.)
template <class Scalar>
struct Vector3 {
  /// The coordinates.
  Scalar x{}, y{}, z{};

  /// Component by component.
  constexpr Vector3& operator+=(const Vector3& v) {
    x = x + v.x, y = y + v.y, z = z + v.z;
    return *this;
  }
  /// Component by component.
  friend constexpr Vector3 operator+(const Vector3& u, const Vector3& v) {
    return {u.x + v.x, u.y + v.y, u.z + v.z};
  }
  /// Component by component.
  friend constexpr Vector3 operator-(const Vector3& u, const Vector3& v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
  }
  /// The opposite.
  friend constexpr Vector3 operator-(const Vector3& v) { return {-v.x, -v.y, -v.z}; }
  /// Component by component.
  friend constexpr Vector3 operator*(const Scalar& k, const Vector3& v) {
    return {k * v.x, k * v.y, k * v.z};
  }
  /// Component by component.
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

/// Euclidean inner product.
template <class Scalar>
constexpr Scalar dot(const Vector3<Scalar>& u, const Vector3<Scalar>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// Right-handed cross product.
template <class Scalar>
constexpr Vector3<Scalar> cross(const Vector3<Scalar>& u, const Vector3<Scalar>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// The vector in another scalar, component by component.
template <class To, class From>
constexpr Vector3<To> vector_cast(const Vector3<From>& v) {
  return {To(v.x), To(v.y), To(v.z)};
}

/// The Euclidean norm, for scalars that have square roots.
template <class Scalar>
Scalar length(const Vector3<Scalar>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

/// The largest absolute value of a component.
inline double max_norm(const Vector3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The vector of length 1 along `v`.
/// @pre v is not 0
template <class Scalar>
Vector3<Scalar> unit(const Vector3<Scalar>& v) {
  return Scalar(Scalar(1) / length(v)) * v;
}

/// The vector of length 1 along `v`, or 0 if the length of `v` is 0.
template <class Scalar>
Vector3<Scalar> unit_or_zero(const Vector3<Scalar>& v) {
  const Scalar size = length(v);
  return size > 0 ? Scalar(Scalar(1) / size) * v : Vector3<Scalar>{};
}

}  // namespace tensortopo
