// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Arcs of a conic with a rational point, and what forms are on them, by Bernstein coefficients.
#pragma once

#include <optional>

#include "curves/conics.hpp"
#include "polynomial.hpp"

namespace certificate {

/// The sign that all of the numbers share strictly: 1, -1; or 0.
template <class Numbers>
int common_sign(const Numbers& numbers) {
  for (const int sign : {1, -1}) {
    bool all = true;
    for (const auto& x : numbers) all = all && has_sign(x, sign, Zero::fails) == Answer::yes;
    if (all) return sign;
  }
  return 0;
}

/// The coefficients of a form on [0, 1] become those on both halves, times a power of two.
template <class N, std::size_t Count>
void halve(const std::array<N, Count>& form, std::array<N, Count>& left,
           std::array<N, Count>& right) {
  std::array<N, Count> row = form;
  for (std::size_t j = 0; j < Count; ++j) {
    const std::size_t last = Count - 1 - j;
    const N factor(1 << last);
    left[j] = factor * row[0];
    right[last] = factor * row[last];
    for (std::size_t i = 0; i < last; ++i) row[i] += row[i + 1];
  }
}

/// An arc of a conic in the plane of a face: e runs along it as the parameter runs from 0 to 1. The
/// three components of e have their degree 2, forms of e their degree 4; all times positive
/// factors, one for e, one for `zero`, one for the weights.
template <class N>
struct Arc {
  std::array<std::array<N, 3>, 3> e;  ///< of each component the coefficients
  std::array<N, 5> zero;              ///< vanishes exactly at the degenerate tensors of the plane
  std::array<std::array<N, 5>, 3> weight;

  Vector3<N> control(std::size_t k) const { return {e[0][k], e[1][k], e[2][k]}; }

  /// Calls f with each form of this and the same of two others.
  template <class F>
  void with(Arc& p, Arc& q, const F& f) const {
    for (std::size_t i = 0; i < 3; ++i) f(e[i], p.e[i], q.e[i]);
    f(zero, p.zero, q.zero);
    for (std::size_t i = 0; i < 3; ++i) f(weight[i], p.weight[i], q.weight[i]);
  }
  std::array<Arc, 2> halves() const {
    std::array<Arc, 2> result;
    with(result[0], result[1], [](const auto& form, auto& p, auto& q) { halve(form, p, q); });
    return result;
  }
};

/// The coefficients of a form along a quadratic curve, times 3.
template <class N>
std::array<N, 5> along(const Conic<N>& form, const std::array<Vector3<N>, 3>& e) {
  const N three(3);
  const Vector3<N> at0 = form.times(e[0]), at1 = form.times(e[1]), at2 = form.times(e[2]);
  return {N(three * dot(e[0], at0)), N(three * dot(e[0], at1)),
          N(dot(e[0], at2) + N(2) * dot(e[1], at1)), N(three * dot(e[1], at2)),
          N(three * dot(e[2], at2))};
}

/// Three independent vectors.
struct Basis {
  std::array<std::array<int, 3>, 3> vectors;

  template <class N>
  Vector3<N> at(std::size_t i) const {
    return {N(vectors[i][0]), N(vectors[i][1]), N(vectors[i][2])};
  }
};

/// A conic in two arcs whose points with `zero` = 0 are the degenerate tensors of a face's plane,
/// each once; or nothing if signs leave it open whether it is so.
///
/// Of the two conics in which these are, m and n, the combination m(p) n - n(p) m has the point p.
/// If it is regular, each line through p meets it in one more point, so the lines, spanned by p and
/// d = t q + u r, parameterize it: e = 2 c(p, d) d - c(d, d) p. What is left is m, or n, on it, not
/// being zero at p.
/// @param basis  p, q, r
template <class N>
std::optional<std::array<Arc<N>, 2>> arcs_of(const SpanForms<N, 3>& forms, const Basis& basis) {
  const auto [m, n] = forms.across;
  const Vector3<N> p = basis.at<N>(0);
  const N at_m = m(p, p), at_n = n(p, p);
  const auto is_zero_free = [](const N& x) { return common_sign(std::array<N, 1>{x}) != 0; };
  const bool first = is_zero_free(at_m);
  if (!first && !is_zero_free(at_n)) return std::nullopt;
  Conic<N> c;
  for (std::size_t k = 0; k < 6; ++k) c.m[k] = at_m * n.m[k] - at_n * m.m[k];
  if (!is_zero_free(c.determinant())) return std::nullopt;
  const Vector3<N> tangent = c.times(p);
  std::array<Arc<N>, 2> result;
  for (const std::size_t half : {0U, 1U}) {
    // From q to r, and from r to -q.
    const Vector3<N> a = basis.at<N>(1 + half);
    Vector3<N> b = basis.at<N>(2 - half);
    if (half == 1)
      for (N& x : b) x = N(-1) * x;
    const N ta = dot(tangent, a), tb = dot(tangent, b);
    const Vector3<N> ca = c.times(a);
    const N aa = dot(a, ca), ab = dot(b, ca), bb = c(b, b);
    std::array<Vector3<N>, 3> e;
    for (std::size_t k = 0; k < 3; ++k) {
      e[0][k] = N(2) * ta * a[k] - aa * p[k];
      e[1][k] = ta * b[k] + tb * a[k] - ab * p[k];
      e[2][k] = N(2) * tb * b[k] - bb * p[k];
      for (std::size_t i = 0; i < 3; ++i) result[half].e[k][i] = e[i][k];
    }
    result[half].zero = along(first ? m : n, e);
    for (std::size_t i = 0; i < 3; ++i) result[half].weight[i] = along(forms.weight[i], e);
  }
  return result;
}

}  // namespace certificate
