// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// The invariant of a tensor, rounded; 0 for the anisotropy of the zero tensor, and no number for a
/// tensor that is not finite.
double invariant_of(Invariant invariant, const SymmetricTensor<double>& t);

/// An invariant and the value asked for, exactly; kept as decimal text, so that this header needs
/// no number library.
class InvariantLevel {
 public:
  /// Reads "0.5", "9/10" or "2e8" exactly, as `ModeValue` does.
  ///
  /// Throws std::invalid_argument, with the reason, for what is no such number, and unless the
  /// value is positive and, of an anisotropy, below 1: elsewhere the invariant is least or largest
  /// on the level, which is no surface.
  static InvariantLevel parse(Invariant invariant, std::string_view text);

  /// Which invariant.
  Invariant invariant() const { return invariant_; }
  /// The nearest double.
  double approx() const;
  /// The fraction in lowest terms, "9/10", or a whole number.
  const std::string& text() const { return text_; }

  /// The same invariant and the same value, exactly.
  friend bool operator==(const InvariantLevel&, const InvariantLevel&) = default;

 private:
  InvariantLevel(Invariant invariant, std::string text)
      : invariant_(invariant), text_(std::move(text)) {}

  Invariant invariant_;
  std::string text_;
};

}  // namespace tensortopo
