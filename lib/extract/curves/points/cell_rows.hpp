// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/points/enclosures.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// The deviators of a cell's vertices as the rows that its forms are made of, or, after `reduce`,
/// other rows that span the same field.
///
/// Deviators that are parallel up to a small part e, as those of a uniaxial field with six digits,
/// have minors of order e^(n - 1), and intervals of doubles around these are too wide to tell
/// anything. So the part along the former rows is taken from each row, and what remains is brought
/// to the order of one:
///
///     r'_i = s_i (r_i - sum over j < i of c_ij r'_j),   s_i > 0 a power of two.
///
/// The numbers c_ij are any doubles, near the coefficients of Gram and Schmidt. The rows r'_i are
/// enclosed with 150 digits before they are rounded, so nothing is lost to the difference. Both
/// sets of rows have the same span and, up to a positive factor, the same determinant; the weights
/// of r are those of r' put back in order (`forms`).
template <std::size_t Vertices>
class CellRows {
 public:
  explicit CellRows(const std::array<ScaledTensor, Vertices>& tensors) : tensors_(tensors) {}

  /// Takes from each row what it shares with the former ones. False, and nothing changes, where
  /// this leaves no row much smaller, or one that 150 digits do not tell from zero.
  bool reduce();

  /// The rows, reduced or not: for E = double and Extended rounded.
  template <class E>
  std::array<Covector<E>, Vertices> rows() const;

  /// The forms of the field, up to one positive factor of all weights and the determinant.
  template <class E>
  FieldForms<E, Vertices> forms(const std::array<std::size_t, 5>& columns) const;

 private:
  std::array<ScaledTensor, Vertices> tensors_;
  std::optional<std::array<Covector<MultiprecisionInterval>, Vertices>> reduced_;
  std::array<std::array<double, Vertices>, Vertices> taken_{};  ///< c_ij
  std::array<double, Vertices> scale_{};                        ///< s_i
};

}  // namespace tensortopo
