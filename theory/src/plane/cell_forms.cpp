// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/cell_forms.hpp"

#include "tensortopo/algebra/barycentric_polynomial.hpp"

namespace tensortopo::theory {
namespace {

template <std::size_t Degree>
using IntegerForm = BarycentricPolynomial<Integer, 3, Degree>;

IntegerForm<1> weight_form(std::size_t i) {
  IntegerForm<1> form;
  form.coefficients[i] = 1;
  return form;
}

template <std::size_t Degree>
bool of_one_sign(const IntegerForm<Degree>& form) {
  const int sign = form.coefficients[0].sign();
  for (const Integer& c : form.coefficients) {
    if (c.sign() != sign) return false;
  }
  return sign != 0;
}

// Forms in the weights of the corners, for T their combination.
struct Cell {
  IntegerForm<2> size;                        // |T|^2
  IntegerForm<3> cube;                        // tr T^3
  std::array<IntegerTensor, 6> square_terms;  // of T^2, in the order of a quadratic form
  const std::array<IntegerTensor, 3>& corners;

  explicit Cell(const std::array<IntegerTensor, 3>& c) : corners(c) {
    const Integer two(2);
    const auto mixed = [&](std::size_t i, std::size_t j) {
      return square(c[i] + c[j]) - square(c[i]) - square(c[j]);
    };
    square_terms = {square(c[0]), mixed(0, 1), mixed(0, 2),
                    square(c[1]), mixed(1, 2), square(c[2])};
    size = {{inner(c[0], c[0]), two * inner(c[0], c[1]), two * inner(c[0], c[2]), inner(c[1], c[1]),
             two * inner(c[1], c[2]), inner(c[2], c[2])}};
    for (std::size_t i = 0; i < 3; ++i) cube = cube + weight_form(i) * squared_along(c[i]);
  }

  // <T^2, D> and <T, D>.
  IntegerForm<2> squared_along(const IntegerTensor& d) const {
    IntegerForm<2> form;
    for (std::size_t k = 0; k < 6; ++k) form.coefficients[k] = inner(square_terms[k], d);
    return form;
  }
  IntegerForm<1> along(const IntegerTensor& d) const {
    return {{inner(corners[0], d), inner(corners[1], d), inner(corners[2], d)}};
  }
  // Of the sign of the derivative of the mode when T changes along D.
  IntegerForm<4> increase(const IntegerTensor& d) const {
    return size * squared_along(d) - cube * along(d);
  }
};

bool is_monotone(const Cell& cell, const std::array<IntegerTensor, 2>& directions) {
  const IntegerForm<4> first = cell.increase(directions[0]), second = cell.increase(directions[1]);
  // Sixteen directions all around; opposite ones are the same.
  constexpr std::array<std::array<int, 2>, 8> combinations = {
      {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {1, 2}, {2, -1}, {1, -2}}};
  for (const auto& [p, q] : combinations) {
    if (of_one_sign(Integer(p) * first + Integer(q) * second)) return true;
  }
  return false;
}

// By Descartes' rule, where the third weight is zero.
bool is_met_once(const IntegerForm<6>& form, std::size_t opposite) {
  int changes = 0, last = 0;
  for (std::size_t i = 0; i < form.size; ++i) {
    if (form.exponents[i][opposite] != 0) continue;
    const int sign = form.coefficients[i].sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes <= 1;
}

}  // namespace

Level::Level(const Rational& mode_squared)
    : numerator(boost::multiprecision::numerator(mode_squared)),
      denominator(boost::multiprecision::denominator(mode_squared)) {}

Sign Level::at(const IntegerTensor& t) const {
  const Integer size = inner(t, t), cube = inner(square(t), t);
  const Integer value = Integer(6) * denominator * cube * cube - numerator * size * size * size;
  return static_cast<Sign>(value.sign());
}

CellKind kind_of_cell(const std::array<IntegerTensor, 3>& corners,
                      const std::array<IntegerTensor, 2>& directions, const Level& level) {
  const Cell cell(corners);
  const IntegerForm<6> form = Integer(6) * level.denominator * (cell.cube * cell.cube) -
                              level.numerator * (cell.size * (cell.size * cell.size));
  if (of_one_sign(form)) return CellKind::empty;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_met_once(form, i)) return CellKind::unclear;
  }
  return is_monotone(cell, directions) ? CellKind::simple : CellKind::unclear;
}

}  // namespace tensortopo::theory
