// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/likely_direction.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo {

namespace {

template <std::size_t N>
using Direction = std::array<double, N>;

template <std::size_t N>
double inner_product(const Direction<N>& u, const Direction<N>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += u[i] * v[i];
  return sum;
}

/// Makes a gradient a direction: of sum zero and unit length.
template <std::size_t N>
void normalize(Direction<N>& d) {
  double mean = 0;
  for (const double x : d) mean += x / static_cast<double>(N);
  for (auto& x : d) x -= mean;
  const double length = std::sqrt(inner_product(d, d));
  if (length > 0)
    for (auto& x : d) x /= length;
}

/// Directions of the mode's gradient at the vertices and, last, at the centroid.
template <std::size_t N>
std::array<Direction<N>, N + 1> gradients(const ModeForms<double, N>& forms) {
  // Values and derivatives of P and 6 Q at each of these points, from the coefficients.
  std::array<double, N + 1> p{}, q{};
  std::array<Direction<N>, N + 1> dp{}, dq{};
  std::size_t pair = 0, triple = 0;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i; j < N; ++j) {
      const double c = forms.norm.coefficients[pair++];
      p[N] += c, dp[N][i] += c, dp[N][j] += c;
      if (i == j) p[i] = c, dp[i][i] = 2 * c;
      if (i != j) dp[i][j] = c, dp[j][i] = c;
      for (std::size_t k = j; k < N; ++k) {
        const double e = forms.determinant.coefficients[triple++];
        q[N] += e, dq[N][i] += e, dq[N][j] += e, dq[N][k] += e;
        if (i == j && j == k) q[i] = e, dq[i][i] = 3 * e;
        if (i == j && j != k) dq[i][k] = e;
        if (i != j && j == k) dq[j][i] = e;
      }
    }
  std::array<Direction<N>, N + 1> result;
  for (std::size_t v = 0; v <= N; ++v) {
    for (std::size_t k = 0; k < N; ++k) result[v][k] = 2 * p[v] * dq[v][k] - 3 * q[v] * dp[v][k];
    normalize(result[v]);
  }
  return result;
}

/// Leans a direction towards the axis of the narrowest cone around some: to the one furthest off,
/// less and less (Badoiu and Clarkson's iteration for the smallest enclosing ball). Stops once all
/// are within a right angle by a margin.
template <std::size_t N, class Directions>
void lean_to_axis(Direction<N>& d, const Directions& directions, int steps, double enough) {
  for (int step = 2; step < steps + 2; ++step) {
    std::size_t furthest = 0;
    double least = 2;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double c = inner_product(d, directions[i]);
      if (c < least) least = c, furthest = i;
    }
    if (least > enough) return;
    for (std::size_t k = 0; k < N; ++k) d[k] += directions[furthest][k] / step;
    const double length = std::sqrt(inner_product(d, d));
    if (!(length > 0)) return;
    for (auto& x : d) x /= length;
  }
}

/// The directions in which each Bernstein coefficient of the mode's increase grows.
template <std::size_t N>
auto coefficient_directions(const ModeForms<double, N>& forms) {
  using Form = decltype(mode_increase_form(forms, Direction<N>{}));
  std::array<Direction<N>, Form::size> directions{};
  for (std::size_t i = 0; i < N; ++i) {
    Direction<N> along{};
    along[i] = 1;
    const auto form = mode_increase_form(forms, along);
    for (std::size_t k = 0; k < Form::size; ++k) directions[k][i] = form.coefficients[k];
  }
  for (auto& d : directions) normalize(d);
  return directions;
}

/// The two furthest apart have the axis of all between them, in a plane.
Direction<3> axis_in_plane(const std::array<Direction<3>, 4>& directions) {
  std::size_t first = 0, second = 1;
  double least = 2;
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = i + 1; j < directions.size(); ++j)
      if (const double c = inner_product(directions[i], directions[j]); c < least)
        least = c, first = i, second = j;
  Direction<3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = directions[first][k] + directions[second][k];
  normalize(d);
  return d;
}

constexpr int kConeSteps = 10, kCoefficientSteps = 30;

}  // namespace

template <std::size_t Vertices>
std::array<double, Vertices> likely_direction(const ModeForms<double, Vertices>& forms,
                                              DirectionChoice choice) {
  const auto all = gradients(forms);
  auto d = all[Vertices];
  if (choice != DirectionChoice::central) {
    if constexpr (Vertices == 3)
      d = axis_in_plane(all);
    else
      lean_to_axis(d, all, kConeSteps, 2);
  }
  if (choice == DirectionChoice::coefficients)
    lean_to_axis(d, coefficient_directions(forms), kCoefficientSteps, 0);
  double largest = 0;
  for (const double x : d) largest = std::max(largest, std::abs(x));
  if (largest > 0)
    for (auto& x : d) x /= largest;
  return d;
}

template std::array<double, 3> likely_direction(const ModeForms<double, 3>&, DirectionChoice);
template std::array<double, 4> likely_direction(const ModeForms<double, 4>&, DirectionChoice);

}  // namespace tensortopo
