// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// A mode in [-1, 1] as the exact rational number that a person wrote.
///
/// "0.9" is nine tenths, not the double next to it; each computation converts it to its own scalar
/// at the last moment. Kept in lowest terms as decimal text, so that this header needs no number
/// library.
class ModeValue {
 public:
  /// Mode zero.
  ModeValue() = default;

  /// Reads "0.5", "-9/10", "1e-6" or "143/343" exactly.
  ///
  /// Accepts an optional sign followed by either a decimal number (digits on at least one side of
  /// the point, optional exponent) or two natural numbers separated by '/'. Throws
  /// std::invalid_argument, with the reason, for anything else, for a zero denominator, for a value
  /// outside [-1, 1], and for text longer than 300 characters, an exponent beyond 300 or a nonzero
  /// value below 1e-300 (no double could hold the quantities made from it).
  static ModeValue parse(std::string_view text);

  /// The mode of the negated tensors.
  ModeValue opposite() const;
  /// -1, 0 or 1.
  int sign() const;
  /// The nearest double.
  double approx() const;
  /// The fraction in lowest terms, "-9/10", or a whole number "-1", "0", "1".
  std::string text() const;
  /// Decimal digits, with a leading '-' if negative.
  const std::string& numerator() const { return numerator_; }
  /// Decimal digits of a positive number.
  const std::string& denominator() const { return denominator_; }

  /// The same fraction.
  friend bool operator==(const ModeValue&, const ModeValue&) = default;

 private:
  std::string numerator_ = "0";
  std::string denominator_ = "1";
};

/// The mode in a scalar: exact for exact scalars, nearest for rounded ones, an enclosure (a point
/// where a double holds the value, else one ulp wide) for enclosures.
template <FieldScalar Scalar>
Scalar to_scalar(const ModeValue& mode);

/// Everything that the formulas want to know about a mode, computed once.
///
/// A unit tensor of mode mu >= 0 has eigenvalues (3 + s, -2 s, s - 3) / sqrt(18 + 6 s^2), where
/// s = sin(theta) is the paper's parameter sqrt(3) tan(arcsin(mu) / 3), and
/// mu = s (9 - s^2) / (3 + s^2)^(3/2), increasing in s on [0, 1]. Every number below is accurate to
/// a few units in the last place relative to itself (unless it underflows, as mu^2 of 1e-200), also
/// next to |mu| = 0 and 1: 1 - mu^2 is formed from the exact fraction before it is rounded.
template <RealScalar Scalar>
struct ModeParameter {
  /// The mode, with its sign.
  Scalar mu{};
  /// Its magnitude.
  Scalar abs_mu{};
  /// mu^2.
  Scalar mu_squared{};
  /// sin(theta) of |mu|, in [0, 1].
  Scalar s{};
  /// S^2..
  Scalar s_squared{};
  /// 1 - s.
  Scalar one_minus_s{};
  /// In [0, pi/2].
  Scalar theta{};
  /// 1 - s^2 = sqrt(1 - mu^2) / cos^3(arcsin(|mu|) / 3).
  Scalar cos_theta_squared{};
  /// Eigenvalues of the unit tensor of mode +|mu|, in descending order: the medium one is <= 0.
  std::array<Scalar, 3> eigenvalues{};
  /// Sign of the mode: -1, 0, 1.
  int sign = 0;
};

template <RealScalar Scalar>
ModeParameter<Scalar> mode_parameter(const ModeValue& mode);

/// The same from s in [0, 1] and the sign of the mode, for modes that are themselves computed (the
/// mode of a tensor with eigenvalues l1 >= l2 >= l3 has s = 3 |l2| / (l1 - l3)). Here 1 - s is s's
/// rounding.
template <RealScalar Scalar>
ModeParameter<Scalar> mode_parameter_from_s(const Scalar& s, int sign);

/// mu^2 from s^2, exact over an exact field: mu^2 = s^2 (9 - s^2)^2 / (3 + s^2)^3.
template <FieldScalar Scalar>
constexpr Scalar mode_squared_from_s2(const Scalar& s2) {
  const Scalar nine_minus = Scalar(9) - s2, three_plus = Scalar(3) + s2;
  return s2 * nine_minus * nine_minus / (three_plus * three_plus * three_plus);
}

}  // namespace tensortopo
