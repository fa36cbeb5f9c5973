// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>

namespace tensortopo {

/// What an algorithm may ask of a number type; specialised beside each type that we ship.
template <class Scalar>
struct ScalarTraits;

/// Doubles.
template <>
struct ScalarTraits<double> {
  /// Arithmetic never rounds.
  static constexpr bool is_exact = false;
  /// Square roots and elementary functions exist.
  static constexpr bool has_roots = true;
  /// A value stands for a set that contains the true number.
  static constexpr bool is_enclosure = false;
};

/// +, -, * and small integers: enough for polynomials.
template <class T>
concept RingScalar = requires(T p, T q) {
  ScalarTraits<T>::is_exact;
  { p + q } -> std::convertible_to<T>;
  { p - q } -> std::convertible_to<T>;
  { p * q } -> std::convertible_to<T>;
  { -p } -> std::convertible_to<T>;
  T(1);
};

/// A ring scalar with division.
template <class T>
concept FieldScalar = RingScalar<T> && requires(T p, T q) {
  { p / q } -> std::convertible_to<T>;
};

/// A field scalar with a total order: the sign of a value is known.
template <class T>
concept OrderedField = FieldScalar<T> && !ScalarTraits<T>::is_enclosure && std::totally_ordered<T>;

/// An ordered field with square roots and elementary functions (rounded).
template <class T>
concept RealScalar = OrderedField<T> && ScalarTraits<T>::has_roots;

}  // namespace tensortopo
