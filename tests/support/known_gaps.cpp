// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "known_gaps.hpp"

#include <algorithm>

#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {

LongTensors field_of(const TetTensors& tensors) {
  LongTensors field;
  for (std::size_t i = 0; i < 4; ++i) field[i] = deviator(tensor_cast<Real50>(tensors[i]));
  return field;
}

double gap_of(const Deviator<Real50>& t) {
  const Real50 p = norm_form(t);
  return static_cast<double>(Real50(54) * discriminant_form(t) / (p * p * p));
}

bool has_sign(const Deviator<Real50>& t, int sign) {
  return sign > 0 ? determinant_form(t) > 0 : determinant_form(t) < 0;
}

std::vector<double> known_gaps(const LongTensors& field, int sign) {
  std::vector<double> gaps;
  for (const auto& t : field)
    if (has_sign(t, sign)) gaps.push_back(gap_of(t));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      constexpr int n = 400;
      const auto at = [&](double x) { return Real50(1 - x) * field[i] + Real50(x) * field[j]; };
      const auto signed_gap = [&](double x) {
        const auto t = at(x);
        return has_sign(t, sign) ? gap_of(t) : 2 - gap_of(t);
      };
      std::array<double, n + 1> samples;
      for (int k = 0; k <= n; ++k) samples[static_cast<std::size_t>(k)] = signed_gap(double(k) / n);
      for (std::size_t k = 1; k < n; ++k) {
        if (samples[k - 1] < samples[k] || samples[k + 1] < samples[k]) continue;
        double low = double(k - 1) / n, high = double(k + 1) / n;
        for (int step = 0; step < 60; ++step) {  // a least gap in between
          const double a = low + (high - low) / 3, b = high - (high - low) / 3;
          if (signed_gap(a) < signed_gap(b))
            high = b;
          else
            low = a;
        }
        gaps.push_back(signed_gap((low + high) / 2));
      }
    }
  for (std::size_t i = 0; i < 4; ++i) {
    TriangleField<Real50> face;
    for (std::size_t j = 0, k = 0; j < 4; ++j)
      if (j != i) face.vertex[k++] = field[j];
    for (const auto& point : nondegenerate_critical_points(face)) {
      const auto& w = point.weights;
      if (std::any_of(w.begin(), w.end(), [](const Real50& x) { return x < 0; })) continue;
      if (has_sign(point.tensor, sign)) gaps.push_back(gap_of(point.tensor));
    }
  }
  return gaps;
}

}  // namespace tensortopo::test
