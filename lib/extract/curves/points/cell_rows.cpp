// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/cell_rows.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

namespace tensortopo {

namespace {

/// A row at least this much smaller than its tensor makes a reduction worth while.
constexpr double kSmall = 0x1p-4;

/// Rows below this may be zero, for all that 150 digits tell.
constexpr double kNothing = 0x1p-300;

Covector<double> rounded_row(const Covector<MultiprecisionInterval>& row) {
  Covector<double> result;
  for (std::size_t k = 0; k < 5; ++k)
    result[k] = EnclosureOf<MultiprecisionInterval>::middle(row[k]);
  return result;
}

double sum_of_products(const Covector<double>& a, const Covector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 5; ++k) sum += a[k] * b[k];
  return sum;
}

/// An entry as a number of another kind.
template <class E>
E converted_to(const MultiprecisionInterval& x) {
  if constexpr (std::is_same_v<E, FastInterval>) {
    return {mpfr_get_d(x.low.backend().data(), MPFR_RNDD),
            mpfr_get_d(x.high.backend().data(), MPFR_RNDU)};
  } else if constexpr (std::is_same_v<E, Extended>) {
    return to_extended(MultiprecisionInterval::End((x.low + x.high) / 2));
  } else {
    return static_cast<E>(MultiprecisionInterval::End((x.low + x.high) / 2));
  }
}

}  // namespace

template <std::size_t Vertices>
bool CellRows<Vertices>::reduce() {
  auto rows = coordinate_rows<MultiprecisionInterval>(tensors_);
  std::array<Covector<double>, Vertices> rounded;
  double smallest = 1;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const double full = std::sqrt(sum_of_products(rounded_row(rows[i]), rounded_row(rows[i])));
    for (std::size_t j = 0; j < i; ++j) {
      const auto own = rounded_row(rows[i]);
      taken_[i][j] = sum_of_products(own, rounded[j]) / sum_of_products(rounded[j], rounded[j]);
      const MultiprecisionInterval factor(taken_[i][j]);
      for (std::size_t k = 0; k < 5; ++k) rows[i][k] = rows[i][k] - factor * rows[j][k];
    }
    double largest = 0;
    for (const double x : rounded_row(rows[i])) largest = std::max(largest, std::abs(x));
    if (!(largest > kNothing)) return false;
    smallest = std::min(smallest, largest / full);
    scale_[i] = std::ldexp(1.0, -std::ilogb(largest));
    for (auto& x : rows[i]) x = x * MultiprecisionInterval(scale_[i]);
    rounded[i] = rounded_row(rows[i]);
  }
  if (!(smallest < kSmall)) return false;
  reduced_ = std::move(rows);
  return true;
}

template <std::size_t Vertices>
template <class E>
std::array<Covector<E>, Vertices> CellRows<Vertices>::rows() const {
  if (!reduced_) return coordinate_rows<E>(tensors_);
  std::array<Covector<E>, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t k = 0; k < 5; ++k) result[i][k] = converted_to<E>((*reduced_)[i][k]);
  return result;
}

// Of a tensor sum_i w'_i r'_i the weight of r_i is s_i w'_i, and what r'_i takes of a former r'_j,
// s_i c_ij w'_i, is missing from that one's.
template <std::size_t Vertices>
template <class E>
FieldForms<E, Vertices> CellRows<Vertices>::forms(
    const std::array<std::size_t, 5>& columns) const {
  auto result = field_forms(rows<E>(), columns);
  if (!reduced_) return result;
  for (std::size_t i = Vertices; i-- > 0;) {
    result.weight[i] = E(scale_[i]) * result.weight[i];
    for (std::size_t j = 0; j < i; ++j)
      result.weight[j] = result.weight[j] - E(taken_[i][j]) * result.weight[i];
  }
  return result;
}

#define TENSORTOPO_ROWS_AS(Vertices, E)                                        \
  template std::array<Covector<E>, Vertices> CellRows<Vertices>::rows() const; \
  template FieldForms<E, Vertices> CellRows<Vertices>::forms(                  \
      const std::array<std::size_t, 5>&) const;
#define TENSORTOPO_ROWS(Vertices)            \
  template class CellRows<Vertices>;         \
  TENSORTOPO_ROWS_AS(Vertices, double)       \
  TENSORTOPO_ROWS_AS(Vertices, Extended)     \
  TENSORTOPO_ROWS_AS(Vertices, FastInterval)
TENSORTOPO_ROWS(3)
TENSORTOPO_ROWS(4)
#undef TENSORTOPO_ROWS
#undef TENSORTOPO_ROWS_AS

}  // namespace tensortopo
