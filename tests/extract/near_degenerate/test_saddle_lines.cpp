// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Neutral surfaces next to one that crosses itself along a line: of fields with a nearly uniaxial
// characteristic tensor, or next to such a saddle on a face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "extract/subdivision/hessian_metric.hpp"
#include "extract/subdivision/refinement_vertex.hpp"
#include "extract/subdivision/saddle_places.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/cases/strata_laws.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Weights = std::array<double, 4>;

Weights normalized(const std::array<std::int64_t, 4>& shares) {
  double total = 0;
  for (const auto s : shares) total += static_cast<double>(s);
  Weights weights;
  for (std::size_t i = 0; i < 4; ++i) weights[i] = static_cast<double>(shares[i]) / total;
  return weights;
}

Weights between(const Weights& a, const Weights& b, double t) {
  Weights weights;
  for (std::size_t i = 0; i < 4; ++i) weights[i] = (1 - t) * a[i] + t * b[i];
  return weights;
}

double mode_at(const LevelSimplex<double, 4>& simplex, const Weights& weights) {
  return mode(tensor_at(simplex.tensors, weights));
}

/// Runs with the places of each field that a line of saddles crosses.
template <class Visit>
void for_each_line(double rest, std::uint64_t seed, int wanted, const Visit& visit) {
  int found = 0;
  for (std::uint64_t trial = 0; found < wanted && trial < 100 * static_cast<std::uint64_t>(wanted);
       ++trial) {
    const auto tensors = nearly_in_stratum(Stratum::uniaxial_complement, rest, seed + trial);
    const SimplexCase<double, 4> tet(tensors, ModeValue::parse("0"));
    const auto places = detail::saddle_places(tet.simplex, tet.level);
    if (places.size() != 2) continue;
    ++found;
    SCOPED_TRACE(exact_text(tensors));
    visit(tet, places);
  }
  EXPECT_EQ(found, wanted);
}

TEST(SaddleLine, TheModeIsFlatAndZeroAlongIt) {
  const std::uint64_t seed = 20241401;
  SCOPED_TRACE(announce(seed));
  for_each_line(0, seed, trials(40), [](const auto& tet, const auto& places) {
    const Weights from = normalized(places[0]), to = normalized(places[1]);
    for (const double t : {0.0, 0.125, 0.5, 0.75, 1.0}) {
      const Weights at = between(from, to, t);
      EXPECT_NEAR(mode_at(tet.simplex, at), 0, 1e-9);
      // A slope would show at a small distance, where bends do not.
      for (std::size_t i = 0; i < 4; ++i) {
        Weights aside = at;
        aside[i] += 1e-7, aside[(i + 1) % 4] -= 1e-7;
        EXPECT_NEAR(mode_at(tet.simplex, aside), 0, 1e-9);
      }
    }
  });
}

double chord(const Deviator<double>& s, const Deviator<double>& t) {
  const auto difference = (1 / std::sqrt(norm_form(s))) * s - (1 / std::sqrt(norm_form(t))) * t;
  return std::sqrt(norm_form(difference));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// In a cell around the line, however thin, the mode bends along the line about as much as across.
/// The angle between the tensors is hundreds of times that across.
TEST(SaddleLine, EdgesAlongItAreAsShortAsThoseAcross) {
  const std::uint64_t seed = 20241402;
  SCOPED_TRACE(announce(seed));
  std::vector<double> squares, angles;  // along by across
  for_each_line(0x1p-40, seed, trials(40), [&](const auto& tet, const auto& places) {
    const auto vertex_at = [&](const Weights& weights) {
      std::array<RefinementVertex<double, 4>, 4> corners;
      detail::Shares<4> shares;
      for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = detail::corner_vertex(tet.simplex, i);
        shares[i] = static_cast<std::int64_t>(std::ldexp(weights[i], 40));
      }
      return detail::place_among<double, 4, 4>(tet.simplex, tet.level, shares,
                                               {&corners[0], &corners[1], &corners[2], &corners[3]})
          ->vertex;
    };
    const Weights from = normalized(places[0]), to = normalized(places[1]);
    for (const auto& [i, j] : kTetEdges) {
      Weights near_i{}, near_j{};
      near_i[static_cast<std::size_t>(i)] = near_j[static_cast<std::size_t>(j)] = 1;
      const Weights middle = between(from, to, 0.5);
      const auto a = vertex_at(from), b = vertex_at(to),
                 c = vertex_at(between(middle, near_i, 1e-3)),
                 d = vertex_at(between(middle, near_j, 1e-3));
      const auto lengths = detail::hessian_lengths<double>({&a, &b, &c, &d});
      squares.push_back(lengths[0] / lengths[5]);
      angles.push_back(chord(a.tensor, b.tensor) / chord(c.tensor, d.tensor));
    }
  });
  EXPECT_LT(median(squares), 1);
  EXPECT_GT(median(angles), 100);
}

class NextToSaddleLine : public testing::TestWithParam<Stratum> {};

/// However close: cells by angles would be as small along the line as they are across.
TEST_P(NextToSaddleLine, TheNeutralSurfaceIsResolved) {
  const std::uint64_t seed = 20241403;
  SCOPED_TRACE(announce(seed));
  for (const double rest : {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40})
    for (int trial = 0; trial < trials(12); ++trial) {
      const auto tensors =
          nearly_in_stratum(GetParam(), rest, seed + static_cast<std::uint64_t>(trial));
      SCOPED_TRACE("rest " + std::to_string(rest) + '\n' + exact_text(tensors));
      const TetMesh mesh = reference_tet_mesh(tensors);
      const Extraction extraction = extract(mesh, "0");
      EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
      const Outcome found = outcome(extraction);
      EXPECT_EQ(found.reason, "");
      if (trial % 6 == 0) {
        EXPECT_EQ(found, outcome(extract<Real50>(mesh, "0")));
      }
    }
}

// Two of the tensors are the same, so the saddle of the mode is a line of saddles of value 0.
TEST(SaddleLine, LevelsNextToItsValueAreDrawnFromCells) {
  const TetTensors tensors{
      {{1, 0, -1, -1, 0, -1}, {1, 1, 0, -1, -1, 0}, {1, 0, 0, 0, -1, 1}, {1, 0, 0, 0, -1, 1}}};
  const TetMesh mesh = reference_tet_mesh(tensors);
  const auto far = extract(mesh, "-1e-4");
  ASSERT_EQ(unresolved_text(far), "");
  for (const char* mode : {"-1e-9", "-1e-13", "-1e-20"}) {
    SCOPED_TRACE(mode);
    const auto near = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(near), "");
    EXPECT_EQ(flaws(near, mesh), "");
    EXPECT_EQ(near.statistics.sheets_loops, 0u);
    // No critical value lies between the modes.
    EXPECT_EQ(topology_in_tet(near), topology_in_tet(far));
  }
}

INSTANTIATE_TEST_SUITE_P(Strata, NextToSaddleLine,
                         testing::Values(Stratum::uniaxial_complement, Stratum::face_saddle),
                         [](const auto& stratum) { return name_of(stratum.param); });

}  // namespace
}  // namespace tensortopo::test
