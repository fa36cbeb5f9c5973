// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <stdexcept>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/nearest.hpp"
#include "tensortopo/scalar/parse_rational.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {
namespace {

[[noreturn]] void refuse(std::string_view text, const char* reason) {
  std::string shown(text.substr(0, 40));
  if (text.size() > shown.size()) shown += "...";
  throw std::invalid_argument("mode value \"" + shown + "\": " + reason);
}

Rational rational(const ModeValue& mode) {
  using boost::multiprecision::mpz_int;
  return Rational(mpz_int(mode.numerator()), mpz_int(mode.denominator()));
}

template <class Scalar>
struct Conversion {
  static Scalar from(const Rational& value) { return nearest<Scalar>(value); }
};
template <>
struct Conversion<Rational> {
  static Rational from(const Rational& value) { return value; }
};
template <>
struct Conversion<Interval> {
  static Interval from(const Rational& value) {
    const double x = nearest<double>(value);
    const Rational back(x);
    if (back == value) return Interval(x);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return back < value ? Interval(x, std::nextafter(x, infinity))
                        : Interval(std::nextafter(x, -infinity), x);
  }
};

}  // namespace

ModeValue ModeValue::parse(std::string_view text) {
  Rational value;
  try {
    value = parse_rational(text);
  } catch (const std::invalid_argument& problem) {
    refuse(text, problem.what());
  }
  if (value > 1 || value < -1) refuse(text, "outside [-1, 1]");
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

double ModeValue::approx() const { return nearest<double>(rational(*this)); }

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
