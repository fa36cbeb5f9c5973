// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>

namespace tensortopo {

/// The numbers and the rounded operations of `long double` on x86, in software.
///
/// Operations are computed with 136 bits and rounded to 64: with at least twice the bits and two
/// more, rounding twice is as rounding once. (Boost's own differences of 64 bits may be wrong in
/// the last bit where a tiny number is taken away; with 136 bits that is rounded off.)
///
/// Requires  values whose exponents a normal number of the format has.
class SoftwareExtended {
 public:
  SoftwareExtended() = default;
  /// Exact.
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number> SoftwareExtended(Number x)
      : value_(x) {}

  /// The nearest double.
  explicit operator double() const { return static_cast<double>(value_); }
  /// Exact where `long double` has 64 bits or more.
  explicit operator long double() const { return static_cast<long double>(value_); }

  /// Exact.
  SoftwareExtended operator-() const { return SoftwareExtended(Narrow(-value_)); }
  /// The number nearest to the sum.
  friend SoftwareExtended operator+(const SoftwareExtended& a, const SoftwareExtended& b) {
    return rounded(Wide(Wide(a.value_) + Wide(b.value_)));
  }
  /// The number nearest to the difference.
  friend SoftwareExtended operator-(const SoftwareExtended& a, const SoftwareExtended& b) {
    return rounded(Wide(Wide(a.value_) - Wide(b.value_)));
  }
  /// The number nearest to the product.
  friend SoftwareExtended operator*(const SoftwareExtended& a, const SoftwareExtended& b) {
    return rounded(Wide(Wide(a.value_) * Wide(b.value_)));
  }
  /// The number nearest to the quotient.
  friend SoftwareExtended operator/(const SoftwareExtended& a, const SoftwareExtended& b) {
    return rounded(Wide(Wide(a.value_) / Wide(b.value_)));
  }
  /// `*this = *this + b`.
  SoftwareExtended& operator+=(const SoftwareExtended& b) { return *this = *this + b; }
  /// `*this = *this - b`.
  SoftwareExtended& operator-=(const SoftwareExtended& b) { return *this = *this - b; }
  /// `*this = *this * b`.
  SoftwareExtended& operator*=(const SoftwareExtended& b) { return *this = *this * b; }
  /// `*this = *this / b`.
  SoftwareExtended& operator/=(const SoftwareExtended& b) { return *this = *this / b; }

  /// Whether the numbers are equal; not-a-number is equal to none.
  friend bool operator==(const SoftwareExtended& a, const SoftwareExtended& b) {
    return a.value_ == b.value_;
  }
  /// The order of the numbers; of not-a-number there is none.
  friend std::partial_ordering operator<=>(const SoftwareExtended& a, const SoftwareExtended& b) {
    if (a.value_ < b.value_) return std::partial_ordering::less;
    if (a.value_ > b.value_) return std::partial_ordering::greater;
    return a.value_ == b.value_ ? std::partial_ordering::equivalent
                                : std::partial_ordering::unordered;
  }

  /// Exact.
  friend SoftwareExtended abs(const SoftwareExtended& a) { return a < SoftwareExtended() ? -a : a; }
  /// The number nearest to the square root.
  friend SoftwareExtended sqrt(const SoftwareExtended& a) {
    return rounded(Wide(sqrt(Wide(a.value_))));
  }
  /// Exact.
  friend SoftwareExtended ldexp(const SoftwareExtended& a, int exponent) {
    return SoftwareExtended(Narrow(ldexp(a.value_, exponent)));
  }
  /// The exponent of a number that is not 0.
  friend int ilogb(const SoftwareExtended& a) { return static_cast<int>(ilogb(a.value_)); }
  /// Whether it is neither infinite nor not-a-number.
  friend bool isfinite(const SoftwareExtended& a) {
    return boost::multiprecision::isfinite(a.value_);
  }

 private:
  template <unsigned Bits>
  using Binary = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<Bits, boost::multiprecision::digit_base_2, void,
                                           std::int16_t, -16382, 16383>,
      boost::multiprecision::et_off>;
  using Narrow = Binary<64>;
  using Wide = Binary<136>;

  explicit SoftwareExtended(const Narrow& value) : value_(value) {}
  static SoftwareExtended rounded(const Wide& value) {
    return SoftwareExtended(static_cast<Narrow>(value));
  }

  Narrow value_ = 0;
};

}  // namespace tensortopo
