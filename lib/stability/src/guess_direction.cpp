// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "guess_direction.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo::stability {

namespace {

template <std::size_t Size>
using Matrix = std::array<std::array<double, Size>, Size>;

/// Solution of a system with a positive semidefinite matrix, made definite by a little on its
/// diagonal.
template <std::size_t Size>
std::array<double, Size> solve(Matrix<Size> m, std::array<double, Size> x) {
  double trace = 0;
  for (std::size_t i = 0; i < Size; ++i) trace += m[i][i];
  for (std::size_t i = 0; i < Size; ++i) m[i][i] += 0x1p-40 * trace;
  for (std::size_t i = 0; i < Size; ++i)
    for (std::size_t j = i + 1; j < Size; ++j) {
      const double factor = m[j][i] / m[i][i];
      for (std::size_t k = i; k < Size; ++k) m[j][k] -= factor * m[i][k];
      x[j] -= factor * x[i];
    }
  for (std::size_t i = Size; i-- > 0;) {
    for (std::size_t k = i + 1; k < Size; ++k) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  return x;
}

}  // namespace

template <std::size_t Vertices, std::size_t Corners>
std::array<double, Vertices> guess_direction(const BoxSimplex<Vertices>& simplex,
                                             const Part<Vertices, Corners>& part, double nu,
                                             int steps) {
  const Part<Vertices, 1> centre = centre_of(simplex, part);
  const Place<Vertices>& x = centre.places[0];
  const Traceless& t = centre.tensors[0];
  const double size = centre.norms[0];
  if (!(size > 0)) return {};
  const Traceless normal = product(t, t) - (nu * size) * t;
  std::array<Traceless, Vertices> turn;  // W of each vertex
  std::array<double, Vertices> rise, turn_normal;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const Traceless& at = simplex.tensors[i];
    turn[i] = 2.0 * product(t, at) - nu * (size * at + (inner(t, at) / size) * t);
    rise[i] = inner(normal, at);
    turn_normal[i] = inner(turn[i], normal);
  }
  const double normal_squared = inner(normal, normal);
  Matrix<Vertices> turns, fixed;
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = 0; j < Vertices; ++j) {
      turns[i][j] = inner(turn[i], turn[j]);
      fixed[i][j] = 0;
    }
  if constexpr (Corners > 1)
    for (std::size_t a = 0; a < Corners; ++a) {
      const Traceless step = part.tensors[a] - t;
      std::array<double, Vertices> change;
      for (std::size_t i = 0; i < Vertices; ++i) change[i] = inner(turn[i], step);
      for (std::size_t i = 0; i < Vertices; ++i)
        for (std::size_t j = 0; j < Vertices; ++j) fixed[i][j] += change[i] * change[j];
    }
  std::array<double, Vertices> weight, d{};
  double all = 0;
  for (const double e : simplex.radii) all += e;
  for (std::size_t i = 0; i < Vertices; ++i) weight[i] = simplex.radii[i] * all;
  for (int step = 0;; ++step) {
    Matrix<Vertices> m = fixed;
    double sum = 0;
    for (std::size_t i = 0; i < Vertices; ++i) sum += weight[i] * x[i] * x[i];
    for (std::size_t i = 0; i < Vertices; ++i) {
      for (std::size_t j = 0; j < Vertices; ++j)
        m[i][j] += weight[i] * x[i] * turn_normal[j] + weight[j] * x[j] * turn_normal[i] +
                   sum * turns[i][j];
      m[i][i] += weight[i] * normal_squared;
    }
    d = solve(m, rise);
    double largest = 0;
    for (const double c : d) largest = std::max(largest, std::abs(c));
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    for (double& c : d) c /= largest;
    if (step == steps) return d;
    Traceless along{};
    for (std::size_t i = 0; i < Vertices; ++i) along = along + d[i] * turn[i];
    std::array<double, Vertices> change;
    double total = 0;
    for (std::size_t i = 0; i < Vertices; ++i) {
      change[i] = norm(d[i] * normal + x[i] * along);
      total += simplex.radii[i] * change[i];
    }
    for (std::size_t i = 0; i < Vertices; ++i)
      weight[i] = simplex.radii[i] * total / std::max(change[i], 0x1p-20 * total / all);
  }
}

#define TENSORTOPO_INSTANTIATE(Vertices, Corners)        \
  template std::array<double, Vertices> guess_direction( \
      const BoxSimplex<Vertices>&, const Part<Vertices, Corners>&, double, int);
TENSORTOPO_INSTANTIATE(2, 1)
TENSORTOPO_INSTANTIATE(2, 2)
TENSORTOPO_INSTANTIATE(3, 1)
TENSORTOPO_INSTANTIATE(3, 3)
TENSORTOPO_INSTANTIATE(4, 1)
TENSORTOPO_INSTANTIATE(4, 4)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::stability
