// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// The deviator of a symmetric tensor, in coordinates that need no division.
///
/// The diagonal is kept as its differences a = xx - yy and b = yy - zz: exact over any ring, one
/// rounding each in floating point, and blind to the trace, which plays no part in the mode.
template <class Scalar>
struct Deviator {
  /// xx - yy, yy - zz, and the components off the diagonal.
  Scalar a{}, b{}, xy{}, yz{}, xz{};

  /// Component by component.
  friend constexpr Deviator operator+(const Deviator& s, const Deviator& t) {
    return {s.a + t.a, s.b + t.b, s.xy + t.xy, s.yz + t.yz, s.xz + t.xz};
  }
  /// Component by component.
  friend constexpr Deviator operator-(const Deviator& s, const Deviator& t) {
    return {s.a - t.a, s.b - t.b, s.xy - t.xy, s.yz - t.yz, s.xz - t.xz};
  }
  /// Component by component.
  friend constexpr Deviator operator*(const Scalar& k, const Deviator& t) {
    return {k * t.a, k * t.b, k * t.xy, k * t.yz, k * t.xz};
  }
  /// Component by component.
  friend bool operator==(const Deviator&, const Deviator&) = default;
};

/// The deviator in another scalar, component by component. (Of a tensor of doubles, the deviator of
/// the tensor in another scalar is another one: differences of doubles round.)
template <class To, class From>
constexpr Deviator<To> tensor_cast(const Deviator<From>& t) {
  return {To(t.a), To(t.b), To(t.xy), To(t.yz), To(t.xz)};
}

/// The deviator T - (trace T / 3) I of a tensor.
template <class Scalar>
constexpr Deviator<Scalar> deviator(const SymmetricTensor<Scalar>& t) {
  return {t.xx - t.yy, t.yy - t.zz, t.xy, t.yz, t.xz};
}

/// Three times the deviator as a tensor: integer coefficients only, so no scalar rounds a third.
template <class Scalar>
constexpr SymmetricTensor<Scalar> thrice(const Deviator<Scalar>& d) {
  const Scalar three(3);
  return {d.a + d.a + d.b,       d.b - d.a,    -(d.a + d.b + d.b),
          three * d.xy, three * d.yz, three * d.xz};
}

/// Polar form of the quadratic form P(T) = 3 |T|^2: symmetric, bilinear, `norm_form(T, T)` = P.
template <class Scalar>
constexpr Scalar norm_form(const Deviator<Scalar>& s, const Deviator<Scalar>& t) {
  const Scalar diagonal = Scalar(2) * (s.a * t.a + s.b * t.b) + s.a * t.b + s.b * t.a;
  return diagonal + Scalar(6) * (s.xy * t.xy + s.yz * t.yz + s.xz * t.xz);
}

/// P(T) = 3 |T|^2.
template <class Scalar>
constexpr Scalar norm_form(const Deviator<Scalar>& t) {
  return norm_form(t, t);
}

/// The cubic form Q(T) = 27 det T. The mode is sqrt(2) Q / P^(3/2), and the generalized mode mu
/// surface (paper, degree-six equation) is 2 Q^2 = mu^2 P^3.
template <class Scalar>
constexpr Scalar determinant_form(const Deviator<Scalar>& t) {
  const Scalar x = t.a + t.a + t.b, y = t.b - t.a, z = -(t.a + t.b + t.b);
  return x * (y * z - Scalar(9) * t.yz * t.yz) - Scalar(9) * (y * t.xz * t.xz + z * t.xy * t.xy) +
         Scalar(54) * t.xy * t.yz * t.xz;
}

}  // namespace tensortopo
