// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "forms.hpp"

namespace certificate {

/// A direction along which the forms of `rise` are probably positive, with small integer entries: a
/// guess in double arithmetic, for others to prove. A perceptron over their coefficients, which are
/// linear in the direction.
/// @param within_chart  among the directions whose entries have the sum 0
template <std::size_t V, class Rise>
std::optional<std::array<int, V>> likely_direction(const Rise& rise, bool within_chart) {
  using Forms = decltype(rise(std::array<int, V>()));
  constexpr std::size_t kCount = Forms::value_type::kCount;
  std::array<std::array<double, V>, std::tuple_size_v<Forms> * kCount> rows{};
  for (std::size_t j = 0; j < V; ++j) {
    std::array<int, V> axis{};
    axis[j] = 1;
    const Forms forms = rise(axis);
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i][j] = forms[i / kCount].coefficients[i % kCount].value;
  }
  for (auto& row : rows) {
    double mean = 0;
    for (const double x : row) mean += x / static_cast<double>(V);
    for (double& x : row) x -= within_chart ? mean : 0;
  }
  std::array<double, V> d{};
  for (auto& row : rows) {
    double square = 0;
    for (const double x : row) square += x * x;
    const double scale = 1 / std::sqrt(square);
    if (!(scale < 1e300)) return std::nullopt;
    for (std::size_t j = 0; j < V; ++j) d[j] += row[j] *= scale;
  }
  constexpr int kSteps = 40;
  for (int step = 0; step < kSteps; ++step) {
    double length = 0, worst = HUGE_VAL;
    for (const double x : d) length += x * x;
    length = std::sqrt(length);
    if (!(length > 0)) return std::nullopt;
    const std::array<double, V>* lowest = nullptr;
    for (const auto& row : rows) {
      double dot = 0;
      for (std::size_t j = 0; j < V; ++j) dot += row[j] * d[j];
      if (dot < worst) worst = dot, lowest = &row;
    }
    constexpr double kMargin = 1e-3;  // of the rounding to integers below
    if (worst > kMargin * length) {
      std::array<int, V> result;
      for (std::size_t j = 0; j < V; ++j)
        result[j] = static_cast<int>(std::lround(d[j] / length * 65536));
      return result;
    }
    if (lowest == nullptr) return std::nullopt;
    // Reflect at the worst row, or at least pass it.
    const double push = -worst + 0.05 * length;
    for (std::size_t j = 0; j < V; ++j) d[j] += push * (*lowest)[j];
  }
  return std::nullopt;
}

}  // namespace certificate
