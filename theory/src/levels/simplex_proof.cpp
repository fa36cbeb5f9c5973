// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/simplex_proof.hpp"

#include <algorithm>
#include <cmath>

#include "levels/forms.hpp"

namespace tensortopo::theory {
namespace {

using BoundedDouble = Bounded<double>;

// P = 3 |T|^2 and Q = 27 det T as polynomials in the weights of the vertices.
template <std::size_t N>
struct ModeForms {
  Form<N, 2> p;
  Form<N, 3> q;
};

template <std::size_t N>
ModeForms<N> mode_forms(const std::array<BoundedDeviator, N>& tensors) {
  const auto linear = [&](BoundedDouble BoundedDeviator::*entry) { return linear_form(tensors, entry); };
  const Form<N, 1> a = linear(&BoundedDeviator::a), b = linear(&BoundedDeviator::b);
  const Form<N, 1> xy = linear(&BoundedDeviator::xy), yz = linear(&BoundedDeviator::yz),
                   xz = linear(&BoundedDeviator::xz);
  // Diagonal entries of three times the tensor, of sum zero.
  const Form<N, 1> x = a + a + b, y = b - a, z = BoundedDouble(-1) * (a + b + b);
  const Form<N, 2> xy2 = xy * xy, yz2 = yz * yz, xz2 = xz * xz;
  ModeForms<N> forms;
  forms.p = BoundedDouble(2) * (a * a + a * b + b * b) + BoundedDouble(6) * (xy2 + yz2 + xz2);
  forms.q = x * (y * z - BoundedDouble(9) * yz2) - BoundedDouble(9) * (y * xz2 + z * xy2) +
            BoundedDouble(54) * ((xy * yz) * xz);
  return forms;
}

// The coefficient of the highest power of one weight: the value at its vertex.
template <std::size_t N, std::size_t Degree>
const BoundedDouble& corner(const Form<N, Degree>& form, std::size_t vertex) {
  std::size_t row = 0;
  while (form.exponents[row][vertex] != Degree) ++row;
  return form.coefficients[row];
}

template <std::size_t N>
bool is_empty(const ModeForms<N>& forms, const ModeLevel& level, const BoundedDouble& square) {
  const Verdict sign = certified_sign(forms.q.coefficients[0]);
  const Verdict at_level = level.sign > 0 ? Verdict::positive : Verdict::negative;
  if ((level.is_neutral() || sign != at_level) && sign != Verdict::unknown &&
      sign != Verdict::zero && strict_sign(forms.q) == sign) {
    return true;
  }
  if (level.is_neutral()) return false;
  // Positive where |mode| is beyond mu; first at the vertices alone.
  const auto excess_at = [&](const BoundedDouble& p, const BoundedDouble& q) {
    return certified_sign(BoundedDouble(2) * q * q - square * (p * p * p));
  };
  const Verdict first = excess_at(forms.p.coefficients[0], forms.q.coefficients[0]);
  if (first != Verdict::positive && first != Verdict::negative) return false;
  for (std::size_t i = 1; i < N; ++i) {
    if (excess_at(corner(forms.p, i), corner(forms.q, i)) != first) return false;
  }
  return strict_sign(BoundedDouble(2) * (forms.q * forms.q) - square * (forms.p * (forms.p * forms.p))) ==
         first;
}

// 2 P dQ - 3 Q dP, of the sign of the mode's derivative, for each weight on its own.
template <std::size_t N>
std::array<Form<N, 4>, N> increase_forms(const ModeForms<N>& forms) {
  std::array<Form<N, 4>, N> result;
  const Form<N, 2> twice_p = BoundedDouble(2) * forms.p;
  const Form<N, 3> thrice_q = BoundedDouble(3) * forms.q;
  for (std::size_t k = 0; k < N; ++k) {
    std::array<BoundedDouble, N> along{};
    along[k] = BoundedDouble(1);
    result[k] = twice_p * derivative(forms.q, along) - thrice_q * derivative(forms.p, along);
  }
  return result;
}

template <std::size_t N>
double inner_product(const std::array<double, N>& u, const std::array<double, N>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += u[i] * v[i];
  return sum;
}

template <std::size_t N>
void make_unit(std::array<double, N>& v) {
  const double length = std::sqrt(inner_product(v, v));
  if (length > 0)
    for (double& x : v) x /= length;
}

// A direction that lies within a right angle of all rows, if the iteration finds one: it leans,
// less and less, to the row that is furthest off.
template <std::size_t N, std::size_t Rows>
std::array<double, N> likely_direction(const std::array<std::array<double, N>, Rows>& rows) {
  constexpr int steps = 60;
  constexpr double enough = 1.0 / 64;
  std::array<double, N> d{};
  for (const auto& row : rows)
    for (std::size_t k = 0; k < N; ++k) d[k] += row[k];
  make_unit(d);
  for (int step = 2; step < steps + 2; ++step) {
    const std::array<double, N>* furthest = &rows[0];
    double least = 2;
    for (const auto& row : rows) {
      const double c = inner_product(d, row);
      if (c < least) least = c, furthest = &row;
    }
    if (least > enough) break;
    for (std::size_t k = 0; k < N; ++k) d[k] += (*furthest)[k] / step;
    make_unit(d);
  }
  return d;
}

template <std::size_t N>
bool is_monotone(const ModeForms<N>& forms) {
  const std::array<Form<N, 4>, N> increase = increase_forms(forms);
  std::array<std::array<double, N>, Form<N, 4>::size> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < N; ++k) rows[i][k] = increase[k].coefficients[i].value;
    make_unit(rows[i]);
  }
  // A guess, as any direction may be; only what follows counts.
  const std::array<double, N> d = likely_direction(rows);
  Form<N, 4> along = BoundedDouble(d[0], 0) * increase[0];
  for (std::size_t k = 1; k < N; ++k) along = along + BoundedDouble(d[k], 0) * increase[k];
  return strict_sign(along) == Verdict::positive;
}

constexpr int kEdgeDepth = 8;

int crossings_below(const std::array<BoundedDeviator, 2>& ends, const std::array<bool, 2>& above,
                    const ModeLevel& level, const BoundedDouble& square, int depth) {
  if (prove<2>(ends, level, square) != SimplexProof::none) return above[0] != above[1] ? 1 : 0;
  if (depth == kEdgeDepth) return 2;
  const BoundedDeviator middle = ends[0] + ends[1];
  const Verdict at_middle = side(middle, level, square);
  if (at_middle != Verdict::positive && at_middle != Verdict::negative) return 2;
  const bool middle_above = at_middle == Verdict::positive;
  const int first =
      crossings_below({ends[0], middle}, {above[0], middle_above}, level, square, depth + 1);
  if (first >= 2) return first;
  return first +
         crossings_below({middle, ends[1]}, {middle_above, above[1]}, level, square, depth + 1);
}

}  // namespace

template <std::size_t Vertices>
SimplexProof prove(const std::array<BoundedDeviator, Vertices>& tensors, const ModeLevel& level,
                   const Bounded<double>& square) {
  const ModeForms<Vertices> forms = mode_forms(tensors);
  if (is_empty(forms, level, square)) return SimplexProof::empty;
  if (is_monotone(forms)) return SimplexProof::monotone;
  return SimplexProof::none;
}

template SimplexProof prove(const std::array<BoundedDeviator, 2>&, const ModeLevel&,
                            const Bounded<double>&);
template SimplexProof prove(const std::array<BoundedDeviator, 3>&, const ModeLevel&,
                            const Bounded<double>&);
template SimplexProof prove(const std::array<BoundedDeviator, 4>&, const ModeLevel&,
                            const Bounded<double>&);

int crossings(const std::array<BoundedDeviator, 2>& ends, const std::array<bool, 2>& above,
              const ModeLevel& level, const Bounded<double>& square) {
  return crossings_below(ends, above, level, square, 0);
}

}  // namespace tensortopo::theory
