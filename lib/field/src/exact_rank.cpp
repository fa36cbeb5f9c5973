// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "minors.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

using Row = std::array<Rational, 5>;

int rank_by_elimination(std::vector<Row> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 5 && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const Rational factor = rows[i][column] / rows[rank][column];
      for (std::size_t j = column; j < 5; ++j) rows[i][j] -= factor * rows[rank][j];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

double largest_entry(std::span<const SymmetricTensor<double>> tensors) {
  double largest = 0;
  for (const auto& t : tensors)
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) {
      if (!std::isfinite(x))
        throw std::invalid_argument("a tensor has an entry that is not finite");
      largest = std::max(largest, std::abs(x));
    }
  return largest;
}

/// Whether doubles prove that some 4x4 minor is not zero.
///
/// After scaling by a power of two all entries are below 1, the coordinates a and b below 2. A
/// monomial of a minor goes through at most 14 roundings: one per coordinate (4), two in each 2x2
/// minor (4), one product, five additions. So with unit roundoff u the computed minor is within
/// ((1 + u)^14 - 1) S of the exact one, S being the sum of the magnitudes of its monomials, and the
/// computed S is at least (1 - u)^14 S: 32 u S covers both with room for the rounding of the bound
/// itself. Underflows change a product by at most 2^-1074 and are multiplied by at most 2^10
/// afterwards; the fewer than 2^10 of them fit in 2^-900.
bool surely_of_rank_four(const std::array<SymmetricTensor<double>, 4>& tensors, double largest) {
  int exponent = 0;
  std::frexp(largest, &exponent);
  detail::Rows4<double> rows{}, magnitudes{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto scaled = [&](double x) { return std::ldexp(x, -exponent); };
    const auto& t = tensors[i];
    rows[i] = {scaled(t.xx) - scaled(t.yy), scaled(t.yy) - scaled(t.zz), scaled(t.xy), scaled(t.yz),
               scaled(t.xz)};
    for (std::size_t j = 0; j < 5; ++j) magnitudes[i][j] = std::abs(rows[i][j]);
  }
  constexpr double thirty_two_roundoffs = 16 * std::numeric_limits<double>::epsilon();
  const double underflow = std::ldexp(1.0, -900);
  const auto values = detail::minors<false>(rows);
  const auto sums = detail::minors<true>(magnitudes);
  for (std::size_t j = 0; j < 5; ++j)
    if (std::abs(values[j]) > thirty_two_roundoffs * sums[j] + underflow) return true;
  return false;
}

}  // namespace

template <FieldScalar Scalar>
requires(ScalarTraits<Scalar>::is_exact) int field_rank(const TetrahedronField<Scalar>& field) {
  std::vector<Row> rows;
  for (const auto& d : field.vertex) rows.push_back(detail::coordinates(d));
  return rank_by_elimination(std::move(rows));
}
template int field_rank(const TetrahedronField<Rational>&);

int exact_rank(std::span<const SymmetricTensor<double>> tensors) {
  largest_entry(tensors);
  std::vector<Row> rows;
  for (const auto& t : tensors) {
    const auto exact = tensor_cast<Rational>(t);
    rows.push_back(detail::coordinates(deviator(exact)));
  }
  return rank_by_elimination(std::move(rows));
}

int exact_rank(const std::array<SymmetricTensor<double>, 4>& tensors) {
  if (surely_of_rank_four(tensors, largest_entry(tensors))) return 4;
  return exact_rank(std::span<const SymmetricTensor<double>>(tensors));
}

}  // namespace tensortopo
