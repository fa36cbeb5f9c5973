// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/points/enclosures.hpp"
#include "tensortopo/extract/curve_points.hpp"

namespace tensortopo {

/// A chart of the projective plane: (u, v) is the direction centre + u first + v second.
struct DirectionChart {
  Vector3<double> centre{}, first{}, second{};
};

/// The chart around a direction; its vectors are orthonormal up to rounding.
inline DirectionChart chart_around(const Vector3<double>& e) {
  DirectionChart chart;
  chart.centre = unit(e);
  const double x = std::abs(e.x), y = std::abs(e.y), z = std::abs(e.z);
  Vector3<double> axis{1, 0, 0};
  if (y <= x && y <= z)
    axis = {0, 1, 0};
  else if (z <= x && z <= y)
    axis = {0, 0, 1};
  chart.first = unit(cross(chart.centre, axis));
  chart.second = cross(chart.centre, chart.first);
  return chart;
}

template <class E>
Vector3<E> widened(const Vector3<double>& x) {
  return {E(x.x), E(x.y), E(x.z)};
}

template <class E>
Vector3<E> direction_at(const DirectionChart& chart, const E& u, const E& v) {
  return widened<E>(chart.centre) + (u * widened<E>(chart.first) + v * widened<E>(chart.second));
}

/// All directions of a box.
template <class E>
Vector3<E> directions_in(const DirectionBox& box) {
  using Bound = typename EnclosureOf<E>::Bound;
  return direction_at(DirectionChart{box.centre, box.first, box.second},
                      EnclosureOf<E>::between(Bound(box.low[0]), Bound(box.high[0])),
                      EnclosureOf<E>::between(Bound(box.low[1]), Bound(box.high[1])));
}

/// A quadratic form in the coordinates of a chart.
template <class E>
struct ChartForm {
  E one, u, v, uu, uv, vv;

  ChartForm(const SymmetricTensor<E>& form, const DirectionChart& chart) {
    const auto c = widened<E>(chart.centre), p = widened<E>(chart.first),
               q = widened<E>(chart.second);
    const auto twice = [](const E& x) { return E(x + x); };
    one = polar(form, c, c);
    u = twice(polar(form, c, p));
    v = twice(polar(form, c, q));
    uu = polar(form, p, p);
    uv = twice(polar(form, p, q));
    vv = polar(form, q, q);
  }
  E value(const std::array<E, 2>& x) const {
    return one + x[0] * (u + uu * x[0] + uv * x[1]) + x[1] * (v + vv * x[1]);
  }
  std::array<E, 2> gradient(const std::array<E, 2>& x) const {
    return {u + ((uu + uu) * x[0] + uv * x[1]), v + ((vv + vv) * x[1] + uv * x[0])};
  }
};

/// Two forms in the coordinates of a chart.
template <class E>
struct ChartForms {
  std::array<ChartForm<E>, 2> form;

  ChartForms(const std::array<SymmetricTensor<E>, 2>& forms, const DirectionChart& chart)
      : form{ChartForm<E>(forms[0], chart), ChartForm<E>(forms[1], chart)} {}

  std::array<std::array<E, 2>, 2> jacobian(const std::array<E, 2>& x) const {
    return {form[0].gradient(x), form[1].gradient(x)};
  }
};

/// The inverse of a matrix of rounded numbers; nothing if it has none to rounding.
template <class Real>
std::optional<std::array<std::array<Real, 2>, 2>> inverse_of(
    const std::array<std::array<Real, 2>, 2>& m) {
  const Real determinant = determinant_of(m);
  if (!(determinant < Real(0.0)) && !(determinant > Real(0.0))) return std::nullopt;
  const Real scale = Real(1.0) / determinant;
  return std::array<std::array<Real, 2>, 2>{std::array<Real, 2>{m[1][1] * scale, -m[0][1] * scale},
                                            std::array<Real, 2>{-m[1][0] * scale, m[0][0] * scale}};
}

/// Newton's method for two forms in a chart, in rounded arithmetic; it ends where it gets stuck.
/// @param least  no step follows one that is shorter
template <class Real>
std::array<Real, 2> newton_zero(const ChartForms<Real>& forms, std::array<Real, 2> x, int steps,
                                const Real& least = Real(0.0)) {
  for (int i = 0; i < steps; ++i) {
    const auto inverse = inverse_of(forms.jacobian(x));
    if (!inverse) break;
    const Real f = forms.form[0].value(x), g = forms.form[1].value(x);
    const Real du = (*inverse)[0][0] * f + (*inverse)[0][1] * g;
    const Real dv = (*inverse)[1][0] * f + (*inverse)[1][1] * g;
    if (!(du * du + dv * dv < Real(1.0))) break;
    x = {x[0] - du, x[1] - dv};
    if (du * du + dv * dv < least * least) break;
  }
  return x;
}

/// A box of the chart around `centre` that is proved to hold exactly one zero of both forms, by
/// Krawczyk's operator: with Y near the inverse of the Jacobian J and X the box around c,
/// K = c - Y F(c) + (1 - Y J(X)) (X - c) inside X proves one zero, which is in K.
///
/// @param inverse  Y, any matrix
/// @param slack    what the half width of X has over twice the size of Y F(c)
template <class E>
std::optional<std::array<E, 2>> certified_zero(const ChartForms<E>& forms,
                                               const std::array<E, 2>& centre,
                                               const std::array<std::array<E, 2>, 2>& inverse,
                                               const typename EnclosureOf<E>::Bound& slack) {
  using Bound = typename EnclosureOf<E>::Bound;
  const E f = forms.form[0].value(centre), g = forms.form[1].value(centre);
  std::array<E, 2> step;
  Bound largest(0);
  for (std::size_t i = 0; i < 2; ++i) {
    step[i] = inverse[i][0] * f + inverse[i][1] * g;
    largest = std::max(largest, magnitude(step[i]));
  }
  const Bound radius = largest + largest + slack;
  if (!(radius < Bound(1))) return std::nullopt;
  const E ball = EnclosureOf<E>::between(Bound(-radius), radius);
  const auto slope = forms.jacobian({E(centre[0] + ball), E(centre[1] + ball)});
  std::array<E, 2> image;
  for (std::size_t i = 0; i < 2; ++i) {
    E move = -step[i];
    for (std::size_t j = 0; j < 2; ++j) {
      const E product = inverse[i][0] * slope[0][j] + inverse[i][1] * slope[1][j];
      move = move + (E(i == j ? 1.0 : 0.0) - product) * ball;
    }
    if (!(magnitude(move) < radius)) return std::nullopt;
    image[i] = centre[i] + move;
  }
  return image;
}

/// Whether two sets of directions have none in common.
template <class E>
bool are_apart(const Vector3<E>& x, const Vector3<E>& y) {
  const Vector3<E> c = cross(x, y);
  return is_strict(sign_in(c.x)) || is_strict(sign_in(c.y)) || is_strict(sign_in(c.z));
}

}  // namespace tensortopo
