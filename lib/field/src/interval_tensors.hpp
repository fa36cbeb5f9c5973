// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "minors.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/power_of_two.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

namespace detail {

/// An interval whose operations rely on `UpwardRounding` being in force: five times as fast as one
/// whose every operation sets the rounding direction.
using Range = CGAL::Interval_nt<false>;
using UpwardRounding = Range::Protector;

}  // namespace detail

template <>
struct ScalarTraits<detail::Range> {
  static constexpr bool is_exact = false;
  static constexpr bool has_roots = false;
  static constexpr bool is_enclosure = true;
};

namespace detail {

/// A tensor that is known to within rounding.
using IntervalTensor = Deviator<Range>;

inline double middle(const Range& x) { return (x.inf() + x.sup()) / 2; }

inline Deviator<double> middle(const IntervalTensor& t) {
  return {middle(t.a), middle(t.b), middle(t.xy), middle(t.yz), middle(t.xz)};
}

inline IntervalTensor point(const Deviator<double>& t) { return tensor_cast<Range>(t); }

inline bool is_not_zero(const Range& x) { return x.inf() > 0 || x.sup() < 0; }

/// The largest bound of a component.
inline double largest_bound(const IntervalTensor& t) {
  double largest = 0;
  for (const Range& x : {t.a, t.b, t.xy, t.yz, t.xz})
    largest = std::max({largest, std::abs(x.inf()), std::abs(x.sup())});
  return largest;
}

/// Times a power of two such that the largest component is about 1; unchanged if it cannot be.
inline IntervalTensor normalized(const IntervalTensor& t) {
  const double largest = largest_bound(t);
  return std::isfinite(largest) ? Range(inverse_power(largest)) * t : t;
}

/// The deviators of tensors, all times one power of two such that the largest component is about 1.
template <std::size_t Count>
std::array<IntervalTensor, Count> scaled_deviators(
    const std::array<SymmetricTensor<double>, Count>& tensors) {
  // First the tensors: differences of their components may overflow.
  double largest = 0;
  for (const auto& t : tensors) largest = std::max(largest, max_norm(t));
  const Range factor(inverse_power(largest));
  std::array<IntervalTensor, Count> deviators;
  double largest_left = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    deviators[i] = deviator(factor * tensor_cast<Range>(tensors[i]));
    largest_left = std::max(largest_left, largest_bound(deviators[i]));
  }
  const Range rest(inverse_power(largest_left));
  for (auto& t : deviators) t = rest * t;
  return deviators;
}

/// Other tensors with the same span, about orthogonal: where a field varies little, its vertex
/// tensors are nearly parallel, and products of them would lose all digits.
template <std::size_t Count>
std::array<IntervalTensor, Count> spread_out(std::array<IntervalTensor, Count> t) {
  for (std::size_t i = 0; i < Count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double factor = middle(norm_form(t[i], t[j])) / middle(norm_form(t[j]));
      if (std::isfinite(factor)) t[i] = t[i] - Range(factor) * t[j];
    }
    t[i] = normalized(t[i]);
  }
  return t;
}

inline IntervalTensor orthogonal_to(const std::array<IntervalTensor, 4>& t) {
  Rows4<Range> rows{};
  for (std::size_t i = 0; i < 4; ++i) rows[i] = coordinates(t[i]);
  auto covector = minors<false>(rows);
  covector[1] = -covector[1];
  covector[3] = -covector[3];
  return normalized(from_covector(covector));
}

/// A tensor orthogonal to all vertex tensors but one, and about orthogonal to n.
inline IntervalTensor dual_tensor(const std::array<IntervalTensor, 4>& corners, std::size_t corner,
                                  const IntervalTensor& n) {
  std::array<IntervalTensor, 3> others;
  for (std::size_t j = 0, k = 0; j < 4; ++j)
    if (j != corner) others[k++] = corners[j];
  others = spread_out(others);
  return orthogonal_to({others[0], others[1], others[2], point(middle(n))});
}

/// 1 - mode^2 by the discriminant, which does not cancel.
inline Range degenerate_gap(const IntervalTensor& t) {
  const Range p = norm_form(t);
  return Range(54) * discriminant_form(t) / (p * p * p);
}

inline Range enclosure(const Rational& x) {
  if (x == 0) return Range(0);
  const double about = static_cast<double>(x);
  return {std::nextafter(about, -HUGE_VAL), std::nextafter(about, HUGE_VAL)};
}

/// 1 - mode^2 of a mode. (From an interval around the mode it would hold 0 at the modes next to 1.)
inline Range gap_of(const ModeValue& mode) {
  const auto mu = to_scalar<Rational>(mode);
  return enclosure(Rational((1 - mu) * (1 + mu)));
}

}  // namespace detail
}  // namespace tensortopo
