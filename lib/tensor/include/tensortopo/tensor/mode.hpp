// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// The mode 3 sqrt(6) det T / |T|^3 of a nonzero deviator, in [-1, 1].
///
/// With the forms of deviator.hpp it is sqrt(2) Q / P^(3/2). Rounding puts the plain quotient above
/// 1 for a quarter of the degenerate tensors, so it is clamped; and next to +-1 it cannot tell
/// tensors apart that are closer to degenerate than 1e-8: use `lode_angle` there. Scaled by a power
/// of two first: no overflow. Requires d nonzero and finite.
template <RealScalar Scalar>
Scalar mode(const Deviator<Scalar>& d);

/// The mode, or nothing for the zero deviator, which has none.
template <RealScalar Scalar>
std::optional<Scalar> mode_if_defined(const Deviator<Scalar>& d);

/// Lode angle arccos(mode) / 3 in [0, pi/3], in radians, accurate to a few ulp of 1 everywhere.
///
/// As a function of the tensor it is 1-Lipschitz in the angle between deviators (as vectors of a
/// five-dimensional Euclidean space). Near degenerate tensors the arc cosine would lose half of the
/// digits; here the sine comes from the discriminant as a sum of squares. Requires d nonzero.
template <RealScalar Scalar>
Scalar lode_angle(const Deviator<Scalar>& d);

/// Angle in radians, in [0, pi], between two nonzero deviators; accurate for small angles too.
template <RealScalar Scalar>
Scalar angle_between(const Deviator<Scalar>& s, const Deviator<Scalar>& t);

/// The same tensor in coordinates in which <S, T> is the dot product of five numbers.
template <RealScalar Scalar>
std::array<Scalar, 5> orthonormal_coordinates(const Deviator<Scalar>& d);

/// Inverse of `orthonormal_coordinates`.
template <RealScalar Scalar>
Deviator<Scalar> from_orthonormal_coordinates(const std::array<Scalar, 5>& x);

/// The traceless tensor of a deviator.
template <FieldScalar Scalar>
constexpr SymmetricTensor<Scalar> to_tensor(const Deviator<Scalar>& d) {
  const Scalar three(3);
  return {
      (d.a + d.a + d.b) / three, (d.b - d.a) / three, -(d.a + d.b + d.b) / three, d.xy, d.yz, d.xz};
}

/// Discriminant of the characteristic polynomial, product of (lambda_i - lambda_j)^2 over i < j.
///
/// Zero exactly for degenerate tensors, and **P^3 - 2 Q^2 = 54 * discriminant**, hence
/// 1 - mode^2 = 2 discriminant / |T|^6. Computed as the Gram determinant of I, T, T^2, that is
/// (Cauchy and Binet) as a sum of thirteen squares: over any ring no division, over an ordered one
/// never negative, and in floating point its *root* is accurate to a few ulp of |T|^3.
template <RingScalar Scalar>
constexpr Scalar discriminant_form(const Deviator<Scalar>& d) {
  // The minors are blind to multiples of I, so take the representative with yy = 0: no thirds.
  const Scalar xx = d.a, zz = -d.b;
  const Scalar xy2 = d.xy * d.xy, yz2 = d.yz * d.yz, xz2 = d.xz * d.xz;
  const Scalar sxx = xx * xx + xy2 + xz2, syy = xy2 + yz2, szz = zz * zz + yz2 + xz2;
  const Scalar sxy = xx * d.xy + d.xz * d.yz;
  const Scalar syz = d.xy * d.xz + d.yz * zz;
  const Scalar sxz = xx * d.xz + d.xy * d.yz + d.xz * zz;
  const auto sq = [](const Scalar& v) { return v * v; };
  // Differences of diagonal entries (xx - yy, yy - zz, xx - zz) of T and of T^2.
  const Scalar t0 = d.a, t1 = d.b, t2 = d.a + d.b;
  const Scalar u0 = sxx - syy, u1 = syy - szz, u2 = sxx - szz;
  const Scalar diagonal = sq(t0 * u1 - t1 * u0);
  const auto mixed = [&](const Scalar& t, const Scalar& u) {
    return sq(t0 * u - u0 * t) + sq(t1 * u - u1 * t) + sq(t2 * u - u2 * t);
  };
  const Scalar twice = mixed(d.xy, sxy) + mixed(d.yz, syz) + mixed(d.xz, sxz);
  const Scalar off =
      sq(d.xy * syz - d.yz * sxy) + sq(d.yz * sxz - d.xz * syz) + sq(d.xz * sxy - d.xy * sxz);
  return diagonal + Scalar(2) * twice + Scalar(12) * off;
}

}  // namespace tensortopo
