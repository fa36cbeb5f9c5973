// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::stability {

/// A deviator as a matrix, of which inner products are those of tensors.
using Traceless = SymmetricTensor<double>;

inline Traceless traceless(const Deviator<double>& t) {
  return {(t.a + t.a + t.b) / 3, (t.b - t.a) / 3, -(t.a + t.b + t.b) / 3, t.xy, t.yz, t.xz};
}

/// Every result here is a sum of products, in at most 60 roundings, of which the terms' moduli add
/// up to at most twice the product of the factors' Frobenius norms. So it is wrong by at most 120 *
/// 2^-53 < 2^-46 times these. The rest is room for what is done with it.
inline constexpr double kRounding = 0x1p-44;

/// Of the tensors of a `ScaledField`, of which the squared norm is from 1 to 4 but for rounding.
inline constexpr double kLargestNorm = 2.125;

/// Bounds the error of an angle: a cosine is wrong by less than 64 u = 2^-47, and |acos(x + e) -
/// acos(x)| <= (pi/2) sqrt(2 e) < 2^-22. The same holds of arcsines.
inline constexpr double kAngleError = 0x1p-22;

/// Frobenius norm.
inline double norm(const Traceless& t) { return std::sqrt(inner(t, t)); }

/// Deviator of (S T + T S) / 2: the gradient, among deviators, of trace(S T U) by U. Since
/// |trace(T^3)| <= |T|^3 / sqrt(6), its norm is at most |S| |T| / sqrt(6).
inline Traceless product(const Traceless& s, const Traceless& t) {
  const double xx = s.xx * t.xx + s.xy * t.xy + s.xz * t.xz,
               yy = s.xy * t.xy + s.yy * t.yy + s.yz * t.yz,
               zz = s.xz * t.xz + s.yz * t.yz + s.zz * t.zz, mean = (xx + yy + zz) / 3;
  return {xx - mean,
          yy - mean,
          zz - mean,
          (s.xx * t.xy + s.xy * t.yy + s.xz * t.yz + t.xx * s.xy + t.xy * s.yy + t.xz * s.yz) / 2,
          (s.xy * t.xz + s.yy * t.yz + s.yz * t.zz + t.xy * s.xz + t.yy * s.yz + t.yz * s.zz) / 2,
          (s.xx * t.xz + s.xy * t.yz + s.xz * t.zz + t.xx * s.xz + t.xy * s.yz + t.xz * s.zz) / 2};
}

}  // namespace tensortopo::stability
