// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/scalar/parse_rational.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace tensortopo {
namespace {

constexpr std::size_t longest_text = 300;
constexpr int largest_exponent = 300;

[[noreturn]] void refuse(const char* reason) { throw std::invalid_argument(reason); }

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

int take_exponent(std::string_view& rest) {
  const bool negative = !rest.empty() && rest.front() == '-';
  take(rest, "+-");
  const std::string digits = take_digits(rest);
  if (digits.empty()) refuse("the exponent has no digits");
  const auto value = integer(digits);
  if (value > largest_exponent) refuse("the exponent is beyond 300");
  return negative ? -value.convert_to<int>() : value.convert_to<int>();
}

/// What follows the sign.
Rational magnitude(std::string_view rest) {
  const std::string whole = take_digits(rest);
  Rational value;
  if (!whole.empty() && take(rest, "/")) {
    const std::string below = take_digits(rest);
    if (below.empty()) refuse("the denominator has no digits");
    const auto denominator = integer(below);
    if (denominator == 0) refuse("the denominator is zero");
    value = Rational(integer(whole), denominator);
  } else {
    const std::string part = take(rest, ".") ? take_digits(rest) : std::string();
    if (whole.empty() && part.empty()) refuse("not a decimal number or a fraction");
    value = Rational(integer(whole + part)) / power_of_ten(static_cast<int>(part.size()));
    if (take(rest, "eE")) {
      const int exponent = take_exponent(rest);
      const Rational factor = power_of_ten(std::abs(exponent));
      value = exponent < 0 ? Rational(value / factor) : Rational(value * factor);
    }
  }
  if (!rest.empty()) refuse("unexpected characters after the number");
  return value;
}

}  // namespace

Rational parse_rational(std::string_view text) {
  if (text.size() > longest_text) refuse("longer than 300 characters");
  std::string_view rest = text;
  const bool negative = !rest.empty() && rest.front() == '-';
  take(rest, "+-");
  const Rational value = magnitude(rest);
  if (value != 0 && value * power_of_ten(largest_exponent) < 1)
    refuse("smaller than 1e-300 but not zero");
  return negative ? Rational(-value) : value;
}

}  // namespace tensortopo
