// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A direction that may prove a part free, in plain doubles: nobody needs to trust it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "widened.hpp"

namespace certificate {

using Plain = std::array<double, 6>;

inline Plain plain(const Matrix& m) {
  Plain result;
  for (std::size_t k = 0; k < 6; ++k) result[k] = m[k].value;
  return result;
}
inline double inner(const Plain& a, const Plain& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}
inline Plain sum(double x, const Plain& a, double y, const Plain& b) {
  Plain result;
  for (std::size_t k = 0; k < 6; ++k) result[k] = x * a[k] + y * b[k];
  return result;
}
/// The gradient, among deviators, of tr(A B C) by C.
inline Plain gradient(const Plain& a, const Plain& b) {
  Matrix x, y;
  for (std::size_t k = 0; k < 6; ++k) x[k].value = a[k], y[k].value = b[k];
  const Plain m = plain(sixfold(x, y));
  return sum(1.0 / 6, m, 0, m);
}

/// x with (M + a little) x = right, M positive semidefinite.
template <std::size_t V>
std::array<double, V> solution(std::array<std::array<double, V>, V> m, std::array<double, V> right) {
  double trace = 0;
  for (std::size_t i = 0; i < V; ++i) trace += m[i][i];
  for (std::size_t i = 0; i < V; ++i) m[i][i] += 1e-12 * trace;
  for (std::size_t i = 0; i < V; ++i)
    for (std::size_t j = i + 1; j < V; ++j) {
      const double f = m[j][i] / m[i][i];
      for (std::size_t k = i; k < V; ++k) m[j][k] -= f * m[i][k];
      right[j] -= f * right[i];
    }
  for (std::size_t i = V; i-- > 0;) {
    for (std::size_t k = i + 1; k < V; ++k) right[i] -= m[i][k] * right[k];
    right[i] /= m[i][i];
  }
  return right;
}

/// With N the gradient of F's cubic at the middle, and W its derivative, F is there about tr(N A) plus
/// the sum of tr(E_i (d_i N + x_i W)): the sum of e_i |d_i N + x_i W| shall be small where tr(N A) = 1, and
/// so shall what W makes of F along the part. Least squares, reweighted `steps` times.
template <std::size_t V, std::size_t C>
std::array<double, V> guess_direction(const std::array<Widened, V>& corners,
                                      const std::array<std::array<double, V>, C>& places, double nu,
                                      int steps) {
  std::array<Plain, V> at;
  for (std::size_t i = 0; i < V; ++i) at[i] = plain(corners[i].centre);
  const auto field = [&](const std::array<double, V>& x) {
    Plain t{};
    for (std::size_t i = 0; i < V; ++i) t = sum(1, t, x[i], at[i]);
    return t;
  };
  std::array<double, V> x{};
  for (const auto& place : places)
    for (std::size_t i = 0; i < V; ++i) x[i] += place[i] / static_cast<double>(C);
  const Plain t = field(x);
  const double size = std::sqrt(inner(t, t));
  if (!(size > 0)) return {};
  const Plain normal = sum(1, gradient(t, t), -nu * size, t);
  std::array<Plain, V> turn;
  std::array<double, V> rise, weight, d{};
  double all = 0;
  for (std::size_t i = 0; i < V; ++i) {
    turn[i] = sum(2, gradient(t, at[i]), -nu,
                  sum(size, at[i], inner(t, at[i]) / size, t));
    rise[i] = inner(normal, at[i]);
    all += corners[i].radius;
  }
  for (std::size_t i = 0; i < V; ++i) weight[i] = corners[i].radius * all;
  const double squared = inner(normal, normal);
  for (int step = 0;; ++step) {
    std::array<std::array<double, V>, V> m{};
    const auto add = [&](double factor, const auto& row) {
      for (std::size_t i = 0; i < V; ++i)
        for (std::size_t j = 0; j < V; ++j) m[i][j] += factor * row(i) * row(j);
    };
    if (C > 1)
      for (const auto& place : places) {
        const Plain change = sum(1, field(place), -1, t);
        add(1, [&](std::size_t i) { return inner(turn[i], change); });
      }
    for (std::size_t k = 0; k < V; ++k)
      for (std::size_t i = 0; i < V; ++i) {
        for (std::size_t j = 0; j < V; ++j)
          m[i][j] += weight[k] * (x[k] * x[k] * inner(turn[i], turn[j]) +
                                  (i == k ? x[k] * inner(normal, turn[j]) : 0) +
                                  (j == k ? x[k] * inner(normal, turn[i]) : 0));
        if (i == k) m[i][i] += weight[k] * squared;
      }
    d = solution(m, rise);
    double largest = 0;
    for (const double entry : d) largest = std::max(largest, std::abs(entry));
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    for (double& entry : d) entry /= largest;
    if (step == steps) return d;
    Plain along{};
    for (std::size_t i = 0; i < V; ++i) along = sum(1, along, d[i], turn[i]);
    std::array<double, V> moved;
    double total = 0;
    for (std::size_t i = 0; i < V; ++i) {
      const Plain m_i = sum(d[i], normal, x[i], along);
      moved[i] = std::sqrt(inner(m_i, m_i));
      total += corners[i].radius * moved[i];
    }
    if (!(all > 0) || !(total > 0)) return d;
    for (std::size_t i = 0; i < V; ++i)
      weight[i] = corners[i].radius * total / std::max(moved[i], 1e-6 * total / all);
  }
}

}  // namespace certificate
