// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/characteristic_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "minors.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/nearest.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

/// Rows times powers of two that bring the largest entry of each into [1/2, 1).
template <class Scalar>
detail::Rows4<Scalar> scaled_rows(const TetrahedronField<Scalar>& field) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  detail::Rows4<Scalar> rows{};
  for (std::size_t i = 0; i < 4; ++i) {
    rows[i] = detail::coordinates(field.vertex[i]);
    Scalar largest(0);
    for (const Scalar& x : rows[i]) {
      if (!(x - x == Scalar(0)))
        throw std::invalid_argument("a vertex tensor has an entry that is not finite");
      if (abs(x) > largest) largest = abs(x);
    }
    int exponent = 0;
    frexp(largest, &exponent);
    for (Scalar& x : rows[i]) x = ldexp(x, -exponent);
  }
  return rows;
}

/// A covector that vanishes on four rows, by elimination with complete pivoting; nothing if a pivot
/// is below 2^-20 of the first one, where elimination would lose too many digits.
template <class Scalar>
std::optional<std::array<Scalar, 5>> null_covector(detail::Rows4<Scalar> rows) {
  using std::abs;
  using std::ldexp;
  std::array<std::size_t, 5> column = {0, 1, 2, 3, 4};
  Scalar smallest_accepted(0);
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot_row = k, pivot_column = k;
    for (std::size_t i = k; i < 4; ++i)
      for (std::size_t j = k; j < 5; ++j)
        if (abs(rows[i][column[j]]) > abs(rows[pivot_row][column[pivot_column]]))
          pivot_row = i, pivot_column = j;
    std::swap(rows[k], rows[pivot_row]);
    std::swap(column[k], column[pivot_column]);
    const Scalar pivot = rows[k][column[k]];
    if (k == 0) smallest_accepted = ldexp(Scalar(abs(pivot)), -20);
    if (pivot == Scalar(0) || abs(pivot) < smallest_accepted) return std::nullopt;
    for (std::size_t i = k + 1; i < 4; ++i) {
      const Scalar factor = rows[i][column[k]] / pivot;
      for (std::size_t j = k + 1; j < 5; ++j)
        rows[i][column[j]] = rows[i][column[j]] - factor * rows[k][column[j]];
    }
  }
  std::array<Scalar, 5> x{};
  x[column[4]] = Scalar(1);
  for (std::size_t k = 4; k-- > 0;) {
    Scalar sum(0);
    for (std::size_t j = k + 1; j < 5; ++j) sum = sum + rows[k][column[j]] * x[column[j]];
    x[column[k]] = -sum / rows[k][column[k]];
  }
  return x;
}

/// The cross product in rationals.
template <class Scalar>
Deviator<Rational> exact_direction(const detail::Rows4<Scalar>& rows) {
  TetrahedronField<Rational> exact;
  for (std::size_t i = 0; i < 4; ++i)
    exact.vertex[i] = {exactly(rows[i][0]), exactly(rows[i][1]), exactly(rows[i][2]),
                       exactly(rows[i][3]), exactly(rows[i][4])};
  return characteristic_direction(exact);
}

/// Rounded after division by the largest coordinate; nothing for zero.
template <class Scalar>
std::optional<Deviator<Scalar>> rounded_direction(const Deviator<Rational>& direction) {
  Rational largest = 0;
  for (const Rational& x : detail::coordinates(direction))
    largest = std::max(largest, x < 0 ? Rational(-x) : x);
  if (largest == 0) return std::nullopt;
  const auto part = [&](const Rational& x) { return nearest<Scalar>(Rational(x / largest)); };
  return Deviator<Scalar>{part(direction.a), part(direction.b), part(direction.xy),
                          part(direction.yz), part(direction.xz)};
}

/// Where eigenvalues say "neutral" or "degenerate" to rounding, asks the exact direction, and makes
/// them say so exactly if it is true.
template <class Scalar>
void settle_special_eigenvalues(CharacteristicTensor<Scalar>& t,
                                const detail::Rows4<Scalar>& rows) {
  using std::ldexp;
  using std::sqrt;
  // A pivot of 2^-20 lets this much through; the angle to degenerate is read off with the same
  // error.
  const Scalar doubt = ldexp(std::numeric_limits<Scalar>::epsilon(), 24);
  auto& [b1, b2, b3] = t.eigenvalues;
  if (b2 <= doubt && determinant_form(exact_direction(rows)) == 0) {
    b1 = sqrt(Scalar(1) / Scalar(2));
    b2 = Scalar(0);
    b3 = -b1;
    t.mode = Scalar(0);
  } else if (b1 - b2 <= doubt && discriminant_form(exact_direction(rows)) == 0) {
    b1 = b2 = sqrt(Scalar(1) / Scalar(6));
    b3 = -(b1 + b1);
    t.mode = Scalar(-1);
  }
}

}  // namespace

template <RealScalar Scalar>
std::optional<CharacteristicTensor<Scalar>> characteristic_tensor(
    const TetrahedronField<Scalar>& field) {
  using std::sqrt;
  const detail::Rows4<Scalar> rows = scaled_rows(field);
  std::optional<Deviator<Scalar>> direction;
  if (const auto covector = null_covector(rows))
    direction = detail::from_covector(*covector);
  else
    direction = rounded_direction<Scalar>(exact_direction(rows));
  if (!direction) return std::nullopt;
  Scalar factor = sqrt(Scalar(3) / norm_form(*direction));
  if (determinant_form(*direction) > Scalar(0)) factor = -factor;
  const Deviator<Scalar> unit = factor * *direction;
  CharacteristicTensor<Scalar> result;
  result.tensor = to_tensor(unit);
  const Eigensystem<Scalar> eigen = eigen_decomposition(result.tensor);
  result.eigenvalues = eigen.values;
  // Rounding must not push the medium eigenvalue across zero, to the wrong sign of the tensor.
  if (result.eigenvalues[1] < Scalar(0)) result.eigenvalues[1] = Scalar(0);
  result.eigenvectors = eigen.vectors;
  result.mode = mode(unit);
  settle_special_eigenvalues(result, rows);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                        \
  template std::optional<CharacteristicTensor<Scalar>> characteristic_tensor( \
      const TetrahedronField<Scalar>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
