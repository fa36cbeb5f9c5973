// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "interval_lines.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/scalar/rational.hpp"

/// \file
/// What the critical points of edges, faces and tetrahedra have in common. Everything here relies
/// on `UpwardRounding` being in force.

namespace tensortopo::detail {

inline IntervalTensor enclosure(const SymmetricTensor<double>& t) {
  return scaled_deviators(std::array{t})[0];
}

template <std::size_t Count>
std::array<IntervalTensor, Count> enclosures(
    const std::array<SymmetricTensor<double>, Count>& tensors) {
  std::array<IntervalTensor, Count> t;
  for (std::size_t i = 0; i < Count; ++i) t[i] = enclosure(tensors[i]);
  return t;
}

template <std::size_t Count>
bool are_independent(const std::array<SymmetricTensor<double>, Count>& tensors) {
  return exact_rank(std::span<const SymmetricTensor<double>>(tensors)) == int{Count};
}

inline Verdict sign_in(const Range& x) {
  if (x.inf() > 0) return Verdict::positive;
  if (x.sup() < 0) return Verdict::negative;
  return Verdict::unknown;
}

inline Range root_of(const Range& x) { return CGAL::sqrt(Range(std::max(x.inf(), 0.0), x.sup())); }

/// The mode is in [low, high], given that its square is 1 - gap; and the gap itself.
inline void narrow_by_gap(CriticalPoint& point, const Range& gap, const Range& determinant) {
  point.gap_low = std::max(point.gap_low, gap.inf());
  point.gap_high = std::min(point.gap_high, gap.sup());
  const Range size = root_of(Range(1) - Range(std::max(gap.inf(), 0.0), std::min(gap.sup(), 1.0)));
  const bool up = determinant.inf() >= 0, down = determinant.sup() <= 0;
  if (!up) point.low = std::max(point.low, -size.sup());
  if (!down) point.high = std::min(point.high, size.sup());
  if (up) point.low = std::max(point.low, size.inf());
  if (down) point.high = std::min(point.high, -size.inf());
}

/// Encloses the mode of a tensor: by the quotient, and next to 1 and -1 by the discriminant.
inline void enclose_mode(CriticalPoint& point, const IntervalTensor& t) {
  const Range p = norm_form(t), q = determinant_form(t);
  if (!(p.inf() > 0)) return;
  const Range quotient = root_of(Range(2)) * q / (p * root_of(p));
  point.low = std::max(point.low, quotient.inf());
  point.high = std::min(point.high, quotient.sup());
  narrow_by_gap(point, degenerate_gap(t), q);
}

/// Along a line of tensors: 2 P Q' - 3 Q P', which has the sign of the mode's derivative.
inline Polynomial increase_along(const Line& line) {
  Polynomial q_part = times(line.norm, derivative(line.determinant));
  Polynomial p_part = times(derivative(line.norm), line.determinant);
  for (auto& c : q_part) c *= Range(2);
  for (auto& c : p_part) c *= Range(3);
  return minus(q_part, p_part);
}

/// The values of a function in parts of x, by the mean value theorem.
template <class Value, class Slope, class Take>
void in_parts(const Range& x, const Value& value, const Slope& slope, const Take& take) {
  constexpr int kParts = 64;
  const double step = (x.sup() - x.inf()) / kParts;
  double from = x.inf();
  for (int i = 1; i <= kParts && from <= x.sup(); ++i) {
    const double to = i == kParts ? x.sup() : std::min(x.sup(), from + step);
    const Range part(from, to), m(middle(part));
    take(value(m) + slope(part) * (part - m));
    if (!(to > from)) break;
    from = to;
  }
}

/// The first and second derivative of the mode at a tensor, times positive numbers; the second
/// one where the first vanishes.
template <class Scalar>
struct Derivatives {
  explicit Derivatives(const Deviator<Scalar>& at)
      : t(at), m(thrice(at)), mm(square(m)), p(norm_form(at)), q(determinant_form(at)) {}

  Scalar first(const Deviator<Scalar>& u) const {
    return Scalar(2) * p * inner(mm, thrice(u)) - Scalar(6) * q * norm_form(t, u);
  }
  // From Q - mode P^(3/2), as Q = tr M^3 / 3 for M three times a traceless tensor.
  Scalar second(const Deviator<Scalar>& u, const Deviator<Scalar>& v) const {
    const auto k = thrice(v);
    const Scalar cubic = inner(square(m + k) - mm - square(k), thrice(u));
    return Scalar(4) * p * p * cubic - Scalar(12) * p * q * norm_form(u, v) -
           Scalar(12) * q * norm_form(t, u) * norm_form(t, v);
  }

  Deviator<Scalar> t;
  SymmetricTensor<Scalar> m, mm;
  Scalar p, q;
};

/// (In mode_along_segments.cpp.)
DeviatorBox box_of(const IntervalTensor& t);

inline void look_around(CriticalPoint& point, const Derivatives<Range>& d,
                        std::span<const SymmetricTensor<double>> around) {
  for (std::size_t i = 0; i < around.size(); ++i)
    point.towards[i] = sign_in(d.first(enclosure(around[i])));
}

/// Weights of the tensors as given from those of normalized ones.
template <std::size_t Count>
inline void set_weights(CriticalPoint& point, std::array<double, Count> weights,
                        const std::array<SymmetricTensor<double>, Count>& given,
                        const std::array<IntervalTensor, Count>& normal) {
  double largest = 0;
  for (const auto& t : given) largest = std::max(largest, max_norm(t));
  const double unit = inverse_power(largest);
  double sum = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto d = deviator(unit * given[i]);
    const double scale =
        norm_form(d) > 0 ? std::sqrt(norm_form(middle(normal[i])) / norm_form(d)) : 1;
    sum += weights[i] = std::max(weights[i] * scale, 0.0);
  }
  for (std::size_t i = 0; i < Count; ++i)
    point.weights[i] = sum > 0 && std::isfinite(sum) ? weights[i] / sum : 1.0 / Count;
}

/// The tensors critical on what is orthogonal to N (given by its line and a place on it), up to
/// sign: N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N, times a positive number.
template <class Scalar>
Deviator<Scalar> critical_tensor(const SymmetricTensor<Scalar>& m, const Scalar& p,
                                 const Scalar& q) {
  return deviator(p * square(m) - q * m);
}

/// Divided by a number such that the largest component is 1.
inline Deviator<Rational> normalized(const Deviator<Rational>& t) {
  Rational largest = 0;
  for (const Rational& x : {t.a, t.b, t.xy, t.yz, t.xz})
    largest = std::max(largest, Rational(abs(x)));
  return largest == 0 ? t : (Rational(1) / largest) * t;
}

inline IntervalTensor enclosure(const Deviator<Rational>& t) {
  return {enclosure(t.a), enclosure(t.b), enclosure(t.xy), enclosure(t.yz), enclosure(t.xz)};
}

}  // namespace tensortopo::detail
