// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/likely_direction.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/extract/mode_forms.hpp"

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

/// Gradient of the mode at a tensor of the simplex, of unit length in the barycentric metric.
template <std::size_t N>
Direction<N> unit_gradient(const std::array<Deviator<double>, N>& tensors,
                           const Deviator<double>& at) {
  const auto m = thrice(at);
  const auto adjugate = detail::polar_adjugate(m, m);
  const double p = norm_form(at), q3 = inner(adjugate, m) / 2;
  Direction<N> d;
  double mean = 0;
  for (std::size_t i = 0; i < N; ++i) {
    d[i] = p * inner(adjugate, thrice(tensors[i])) - 2 * q3 * norm_form(at, tensors[i]);
    mean += d[i] / static_cast<double>(N);
  }
  for (auto& x : d) x -= mean;
  const double length = std::sqrt(inner_product(d, d));
  if (length > 0)
    for (auto& x : d) x /= length;
  return d;
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
auto coefficient_directions(const std::array<Deviator<double>, N>& tensors) {
  const auto forms = mode_forms(tensors);
  using Form = decltype(mode_increase_form(forms, Direction<N>{}));
  std::array<Direction<N>, Form::size> directions{};
  for (std::size_t i = 0; i < N; ++i) {
    Direction<N> along{};
    along[i] = 1;
    const auto form = mode_increase_form(forms, along);
    for (std::size_t k = 0; k < Form::size; ++k) directions[k][i] = form.coefficients[k];
  }
  for (auto& d : directions) {
    double mean = 0;
    for (const double x : d) mean += x / static_cast<double>(N);
    for (auto& x : d) x -= mean;
    const double length = std::sqrt(inner_product(d, d));
    if (length > 0)
      for (auto& x : d) x /= length;
  }
  return directions;
}

constexpr int kConeSteps = 10, kCoefficientSteps = 30;

}  // namespace

template <std::size_t Vertices>
std::array<double, Vertices> likely_direction(
    const std::array<Deviator<double>, Vertices>& tensors, DirectionChoice choice) {
  Deviator<double> centre = tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) centre = centre + tensors[i];
  auto d = unit_gradient(tensors, centre);
  if (choice != DirectionChoice::central) {
    std::array<Direction<Vertices>, Vertices + 1> gradients;
    for (std::size_t i = 0; i < Vertices; ++i) gradients[i] = unit_gradient(tensors, tensors[i]);
    gradients[Vertices] = d;
    lean_to_axis(d, gradients, kConeSteps, 2);
  }
  if (choice == DirectionChoice::coefficients)
    lean_to_axis(d, coefficient_directions(tensors), kCoefficientSteps, 1e-6);
  double largest = 0;
  for (const double x : d) largest = std::max(largest, std::abs(x));
  if (largest > 0)
    for (auto& x : d) x /= largest;
  return d;
}

template std::array<double, 3> likely_direction(const std::array<Deviator<double>, 3>&,
                                                DirectionChoice);
template std::array<double, 4> likely_direction(const std::array<Deviator<double>, 4>&,
                                                DirectionChoice);

}  // namespace tensortopo
