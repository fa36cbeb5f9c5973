// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The mode asked for, as the numbers that the extraction needs.
template <class Scalar>
struct Level {
  ModeValue value;  ///< exact; never +-1
  /// Of the mode. Neutral tensors are taken as a limit of positive modes: the level is mu + 0, and
  /// the dominant eigenvector the major one.
  int sign = 1;
  Scalar mu{};  ///< signed
  Scalar mu_squared{};
  Scalar sqrt2{};
  std::array<Scalar, 3> eigenvalues{};  ///< of the unit tensor of mode mu, descending
  double lode_angle = 0;                ///< arccos(mu) / 3, for screening
  ModeParameter<double> parameter;      ///< for the medium eigenvector manifold

  /// 1 - mode^2: small for levels next to modes 1 and -1.
  double gap() const { return static_cast<double>(Scalar(1) - mu_squared); }
};

template <class Scalar>
Level<Scalar> make_level(const ModeValue& value);

/// Half the distance from 1 to the next number: the relative error of one rounding.
template <class Scalar>
inline Scalar unit_roundoff() {
  static const Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
  return u;
}

/// A tensor of the linear field on a simplex is a sum of at most four vertex tensors of norm
/// form P <= 12 each (vertex tensors are scaled so that P lies in [3, 12)); at exact homogeneous
/// coordinates of sum `total` it is wrong by at most 9 roundings of such a term in each component,
/// that is by less than 40 total u in sqrt(P). This is the factor by which that error, relative to
/// the norm at hand, exceeds one rounding.
template <class Scalar>
inline Scalar rounding_unit(const Scalar& norm, double total = 1) {
  return unit_roundoff<Scalar>() * (Scalar(1) + Scalar(40 * total) / norm);
}

/// sqrt(2) Q - mu P^(3/2): positive where the mode is larger than mu. One signed sheet, unlike
/// the degree-six form, and no double root.
template <class Scalar>
inline Scalar level_function(const Deviator<Scalar>& t, const Level<Scalar>& level) {
  using std::sqrt;
  const Scalar p = norm_form(t);
  return level.sqrt2 * determinant_form(t) - level.mu * p * sqrt(p);
}

/// Side of the level on which a tensor lies, if rounding cannot have changed it; `total` as in
/// `rounding_unit`.
/// In absolute values the two terms add up to less than 200 N^3 (N^2 = P; the components of
/// thrice(T) are at most sqrt(3) N), and no term passes through more than 20 roundings.
template <class Scalar>
inline Verdict side_of_level(const Deviator<Scalar>& t, const Level<Scalar>& level,
                             double total = 1) {
  using std::sqrt;
  const Scalar p = norm_form(t);
  const Scalar n = sqrt(p);
  if (!(n > Scalar(0))) return Verdict::unknown;
  const Scalar value = level.sqrt2 * determinant_form(t) - level.mu * p * n;
  const Scalar bound = Scalar(4000) * rounding_unit(n, total) * p * n;
  if (value > bound) return Verdict::positive;
  if (value < -bound) return Verdict::negative;
  return Verdict::unknown;
}

/// Value and gradient data of the level function at a tensor: its derivative in the direction of
/// another tensor is `inner(slope, thrice(direction))`.
template <class Scalar>
struct LevelSlope {
  Scalar value{};
  SymmetricTensor<Scalar> slope{};
};

template <class Scalar>
LevelSlope<Scalar> level_slope(const Deviator<Scalar>& t, const Level<Scalar>& level);

/// Unit medium eigenvector of a tensor whose mode is the level's (its sign is arbitrary).
/// The eigenvalue is known from the mode and the norm, so the vector is a cross product.
template <class Scalar>
Vector3<Scalar> medium_eigenvector(const Deviator<Scalar>& t, const Level<Scalar>& level);

/// Unit dominant eigenvector: of the major eigenvalue for mode > 0, of the minor one for mode < 0.
template <class Scalar>
Vector3<Scalar> dominant_eigenvector(const Deviator<Scalar>& t, const Level<Scalar>& level);

}  // namespace tensortopo
