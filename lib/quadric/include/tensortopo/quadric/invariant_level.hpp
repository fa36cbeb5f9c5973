// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// An invariant of a tensor T with deviator D whose level sets are quadrics in a linear field.
enum class Invariant {
  magnitude,           ///< |T|
  deviator_magnitude,  ///< |D|
  anisotropy,          ///< |D| / |T|, from 0 (isotropic) to 1 (traceless); undefined for T = 0
};

/// The name that the program uses: "magnitude", "deviator-magnitude", "anisotropy".
std::string_view name_of(Invariant invariant);
/// The invariant of that name, if there is one.
std::optional<Invariant> invariant_named(std::string_view name);

/// The invariant of a tensor, rounded; 0 for the anisotropy of the zero tensor.
double invariant_of(Invariant invariant, const SymmetricTensor<double>& t);

/// An invariant and the exact value asked for.
class InvariantLevel {
 public:
  /// Throws std::invalid_argument, with the reason, unless the value is positive and, of an
  /// anisotropy, below 1: elsewhere the level is where the invariant is least or largest, and no
  /// surface.
  InvariantLevel(Invariant invariant, const Rational& value);
  /// Reads the value as `parse_rational` does.
  static InvariantLevel parse(Invariant invariant, std::string_view text);

  Invariant invariant() const { return invariant_; }
  const Rational& value() const { return value_; }
  /// The nearest double.
  double approx() const;
  /// The fraction in lowest terms, "9/10", or a whole number.
  std::string text() const { return value_.str(); }

  friend bool operator==(const InvariantLevel&, const InvariantLevel&) = default;

 private:
  Invariant invariant_;
  Rational value_;
};

}  // namespace tensortopo
