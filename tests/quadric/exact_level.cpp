// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "exact_level.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace tensortopo::test {
namespace {

using Row = std::vector<Rational>;

/// Gauss-Jordan; nothing for a singular matrix. Each row ends with its right-hand side.
std::optional<Row> solve(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Row result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(rows[k][n] / rows[k][k]);
  return result;
}

}  // namespace

ExactLevel::ExactLevel(const TetTensors& tensors, const InvariantLevel& level, int nappe)
    : nappe_(nappe) {
  const Rational v(level.text()), v2 = v * v;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto s = tensor_cast<Rational>(tensors[i]);
    trace_[i] = trace(s);
    for (std::size_t j = 0; j < 4; ++j) {
      const auto t = tensor_cast<Rational>(tensors[j]);
      const Rational of_tensor = inner(s, t);
      const Rational of_deviator = of_tensor - trace(s) * trace(t) / 3;
      switch (level.invariant()) {
        case Invariant::magnitude:
          form_[i][j] = of_tensor - v2;
          break;
        case Invariant::deviator_magnitude:
          form_[i][j] = of_deviator - v2;
          break;
        case Invariant::anisotropy:
          form_[i][j] = of_deviator - v2 * of_tensor;
          break;
      }
    }
  }
}

/// Of the open face: B x = lambda 1, sum x = 1, whose value is lambda.
bool ExactLevel::has_inner_place(unsigned mask) const {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1) corners.push_back(i);
  const std::size_t n = corners.size();
  std::vector<Row> rows(n + 1, Row(n + 2));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = form_[corners[i]][corners[j]];
    rows[i][n] = -1;
    rows[n][i] = 1;
  }
  rows[n][n + 1] = 1;
  const auto x = solve(rows);
  if (!x || (*x)[n] > 0) return false;
  Rational t = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if ((*x)[i] <= 0) return false;
    t += (*x)[i] * trace_[corners[i]];
  }
  return nappe_ == 0 || t * nappe_ > 0;
}

bool ExactLevel::meets(unsigned mask) const {
  for (unsigned part = 1; part < 16; ++part)
    if ((part & mask) == part && has_inner_place(part)) return true;
  return false;
}

int ExactLevel::crossings(int i, int j) const {
  const unsigned a = 1u << i, b = 1u << j;
  if (meets(a) && meets(b)) return 0;
  if (meets(a) || meets(b)) return 1;
  return meets(a | b) ? 2 : 0;
}

int ExactLevel::euler_characteristic() const {
  if (!meets(15)) return 0;
  int faces = 0;
  for (unsigned mask = 1; mask < 15; ++mask)
    if (meets(mask)) faces += std::popcount(mask) == 2 ? -1 : 1;
  return 2 - faces;
}

InvariantLevel level_at(Invariant invariant, const Rational& value) {
  return InvariantLevel::parse(invariant, value.str());
}

std::vector<int> nappes(Invariant invariant) {
  return invariant == Invariant::anisotropy ? std::vector<int>{1, -1} : std::vector<int>{0};
}

std::vector<std::vector<long>> topology(const InvariantExtraction& extraction) {
  std::vector<std::vector<long>> result;
  for (const auto& part : surface_invariants(extraction.surface).parts)
    result.push_back({part.euler_characteristic, part.boundary_loops});
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tensortopo::test
