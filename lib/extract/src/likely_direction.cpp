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

}  // namespace

template <std::size_t Vertices>
std::array<double, Vertices> likely_direction(
    const std::array<Deviator<double>, Vertices>& tensors, DirectionChoice choice) {
  Deviator<double> centre = tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) centre = centre + tensors[i];
  auto d = unit_gradient(tensors, centre);
  if (choice == DirectionChoice::cone) {
    std::array<Direction<Vertices>, Vertices + 1> gradients;
    for (std::size_t i = 0; i < Vertices; ++i) gradients[i] = unit_gradient(tensors, tensors[i]);
    gradients[Vertices] = d;
    // Towards the axis of the narrowest cone around them: lean to the one furthest off, less and
    // less (Badoiu and Clarkson's iteration for the smallest enclosing ball).
    for (int step = 2; step < 10; ++step) {
      std::size_t furthest = 0;
      double least = 2;
      for (std::size_t i = 0; i <= Vertices; ++i) {
        const double c = inner_product(d, gradients[i]);
        if (c < least) least = c, furthest = i;
      }
      for (std::size_t k = 0; k < Vertices; ++k) d[k] += gradients[furthest][k] / step;
      const double length = std::sqrt(inner_product(d, d));
      if (!(length > 0)) break;
      for (auto& x : d) x /= length;
    }
  }
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
