// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <mpfr.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {
namespace {

constexpr std::size_t longest_text = 300;
constexpr int largest_exponent = 300;

[[noreturn]] void refuse(std::string_view text, const char* reason) {
  std::string shown(text.substr(0, 40));
  if (text.size() > shown.size()) shown += "...";
  throw std::invalid_argument("mode value \"" + shown + "\": " + reason);
}

/// The leading digits of `rest`, which are removed from it.
std::string take_digits(std::string_view& rest) {
  std::size_t count = 0;
  while (count < rest.size() && rest[count] >= '0' && rest[count] <= '9') ++count;
  std::string digits(rest.substr(0, count));
  rest.remove_prefix(count);
  return digits;
}

bool take(std::string_view& rest, std::string_view one_of) {
  if (rest.empty() || one_of.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

boost::multiprecision::mpz_int integer(const std::string& digits) {
  // A leading zero would announce octal digits.
  const auto first = digits.find_first_not_of('0');
  return boost::multiprecision::mpz_int(first == std::string::npos ? "0" : digits.substr(first));
}

Rational power_of_ten(int exponent) {
  return Rational(boost::multiprecision::pow(boost::multiprecision::mpz_int(10),
                                             static_cast<unsigned>(exponent)));
}

int take_exponent(std::string_view text, std::string_view& rest) {
  const bool negative = !rest.empty() && rest.front() == '-';
  take(rest, "+-");
  const std::string digits = take_digits(rest);
  if (digits.empty()) refuse(text, "the exponent has no digits");
  const auto value = integer(digits);
  if (value > largest_exponent) refuse(text, "the exponent is beyond 300");
  return negative ? -value.convert_to<int>() : value.convert_to<int>();
}

/// What follows the sign.
Rational magnitude(std::string_view text, std::string_view rest) {
  const std::string whole = take_digits(rest);
  Rational value;
  if (!whole.empty() && take(rest, "/")) {
    const std::string below = take_digits(rest);
    if (below.empty()) refuse(text, "the denominator has no digits");
    const auto denominator = integer(below);
    if (denominator == 0) refuse(text, "the denominator is zero");
    value = Rational(integer(whole), denominator);
  } else {
    const std::string part = take(rest, ".") ? take_digits(rest) : std::string();
    if (whole.empty() && part.empty()) refuse(text, "not a decimal number or a fraction");
    value = Rational(integer(whole + part)) / power_of_ten(static_cast<int>(part.size()));
    if (take(rest, "eE")) {
      const int exponent = take_exponent(text, rest);
      const Rational factor = power_of_ten(std::abs(exponent));
      value = exponent < 0 ? Rational(value / factor) : Rational(value * factor);
    }
  }
  if (!rest.empty()) refuse(text, "unexpected characters after the number");
  return value;
}

Rational rational(const ModeValue& mode) {
  using boost::multiprecision::mpz_int;
  return Rational(mpz_int(mode.numerator()), mpz_int(mode.denominator()));
}

/// Rounds once, to the precision of the target (GMP's own conversion truncates).
void round_into(mpfr_t target, const Rational& value) {
  mpfr_set_q(target, value.backend().data(), MPFR_RNDN);
}

double nearest_double(const Rational& value) {
  mpfr_t rounded;
  mpfr_init2(rounded, std::numeric_limits<double>::digits);
  round_into(rounded, value);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

template <class Scalar>
struct Conversion {
  static Scalar from(const Rational& value) {
    Scalar result;
    round_into(result.backend().data(), value);
    return result;
  }
};
template <>
struct Conversion<double> {
  static double from(const Rational& value) { return nearest_double(value); }
};
template <>
struct Conversion<Rational> {
  static Rational from(const Rational& value) { return value; }
};
template <>
struct Conversion<Interval> {
  static Interval from(const Rational& value) {
    const double nearest = nearest_double(value);
    const Rational back(nearest);
    if (back == value) return Interval(nearest);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return back < value ? Interval(nearest, std::nextafter(nearest, infinity))
                        : Interval(std::nextafter(nearest, -infinity), nearest);
  }
};

}  // namespace

ModeValue ModeValue::parse(std::string_view text) {
  if (text.size() > longest_text) refuse(text, "longer than 300 characters");
  std::string_view rest = text;
  const bool negative = !rest.empty() && rest.front() == '-';
  take(rest, "+-");
  Rational value = magnitude(text, rest);
  if (value > 1) refuse(text, "outside [-1, 1]");
  if (value != 0 && value * power_of_ten(largest_exponent) < 1)
    refuse(text, "smaller than 1e-300 but not zero");
  if (negative) value = -value;
  ModeValue result;
  result.numerator_ = boost::multiprecision::numerator(value).str();
  result.denominator_ = boost::multiprecision::denominator(value).str();
  return result;
}

ModeValue ModeValue::opposite() const {
  ModeValue result = *this;
  if (sign() < 0) result.numerator_.erase(0, 1);
  if (sign() > 0) result.numerator_.insert(0, 1, '-');
  return result;
}

int ModeValue::sign() const {
  if (numerator_ == "0") return 0;
  return numerator_.front() == '-' ? -1 : 1;
}

double ModeValue::approx() const { return nearest_double(rational(*this)); }

std::string ModeValue::text() const {
  return denominator_ == "1" ? numerator_ : numerator_ + "/" + denominator_;
}

template <FieldScalar Scalar>
Scalar to_scalar(const ModeValue& mode) {
  return Conversion<Scalar>::from(rational(mode));
}

#define TENSORTOPO_INSTANTIATE(Scalar) template Scalar to_scalar<Scalar>(const ModeValue&);
TENSORTOPO_FOR_EACH_FIELD(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
