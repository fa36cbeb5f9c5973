// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fields that nearly vanish at a place inside a tetrahedron, on a face or on an edge: all that the
// level does there happens within a short way of that place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "extract/subdivision/small_field.hpp"
#include "extract/topology/subdivision_mesh.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/cases/strata_laws.hpp"
#include "support/compared.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

constexpr std::array<const char*, 5> kModes{"0", "1e-6", "1/2", "-9/10", "99/100"};

class NearlyVanishing : public testing::TestWithParam<Stratum> {};

/// Seen from as near as the field is small it is always the same field.
TEST_P(NearlyVanishing, HasOneTopologyHoweverSmallTheRest) {
  const std::uint64_t seed = 20241301;
  SCOPED_TRACE(announce(seed));
  std::set<std::string> seen;
  for (int trial = 0; trial < trials(25); ++trial) {
    const std::string mode = kModes[static_cast<std::size_t>(trial) % kModes.size()];
    Outcome first;
    for (const double rest : {0x1p-10, 0x1p-23, 0x1p-36}) {
      const auto tensors =
          nearly_in_stratum(GetParam(), rest, seed + static_cast<std::uint64_t>(trial));
      SCOPED_TRACE("trial " + std::to_string(trial) + " at " + mode + '\n' + exact_text(tensors));
      const TetMesh mesh = reference_tet_mesh(tensors);
      const Extraction extraction = extract(mesh, mode);
      EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
      const Outcome found = outcome(extraction);
      EXPECT_EQ(found.reason, "");
      if (rest == 0x1p-10) first = found;
      EXPECT_EQ(found, first) << "with a rest of " << rest;
    }
    std::ostringstream text;
    text << first;
    seen.insert(text.str());
  }
  EXPECT_GT(seen.size(), 2u);
}

TEST_P(NearlyVanishing, HasTheSameTopologyInTwoPrecisions) {
  const std::uint64_t seed = 20241302;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(2); ++trial) {
    const auto tensors =
        nearly_in_stratum(GetParam(), 0x1p-36, seed + static_cast<std::uint64_t>(trial));
    const TetMesh mesh = reference_tet_mesh(tensors);
    EXPECT_EQ(outcome(extract(mesh, "1/2")), outcome(extract<Real50>(mesh, "1/2")))
        << exact_text(tensors);
  }
}

/// Off by roundings: sheets are then smaller than coordinates tell, and triangles have no area.
TEST_P(NearlyVanishing, HasSurfacesWithoutFlawsNextToTheZero) {
  const std::uint64_t seed = 777;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(12); ++trial) {
    Random random(seed + static_cast<std::uint64_t>(trial));
    TetTensors tensors = stratum_tensors(GetParam(), random);
    perturb(tensors, 0x1p-53, random);
    SCOPED_TRACE("trial " + std::to_string(trial) + '\n' + exact_text(tensors));
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction =
        extract(mesh, kModes[static_cast<std::size_t>(trial) % kModes.size()]);
    EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
  }
}

Rational coordinate(const ExactPlace<4>& place, std::size_t i) {
  return Rational(place.high[i]) + Rational(place.low[i]);
}

Rational determinant(const std::array<std::array<Rational, 4>, 4>& rows) {
  Rational sum = 0;
  std::array<std::size_t, 4> p{0, 1, 2, 3};
  do {
    int sign = 1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) sign = p[i] > p[j] ? -sign : sign;
    sum += sign * rows[0][p[0]] * rows[1][p[1]] * rows[2][p[2]] * rows[3][p[3]];
  } while (std::next_permutation(p.begin(), p.end()));
  return sum;
}

/// Cells around a vertex that was put into a face or a cell fill what was there, whatever their
/// size.
TEST_P(NearlyVanishing, IsCutIntoCellsThatFillTheTetrahedron) {
  const std::uint64_t seed = 20241303;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(5); ++trial) {
    const SimplexCase<double, 4> tet(
        nearly_in_stratum(GetParam(), 0x1p-36, seed + static_cast<std::uint64_t>(trial)),
        ModeValue::parse("1/2"));
    Refinement<double, 4> refinement(tet.simplex, tet.level);
    ASSERT_TRUE(refinement.run(50000));
    Rational volume = 0;
    for (const auto& cell : refinement.cells()) {
      if (!cell.alive) continue;
      std::array<std::array<Rational, 4>, 4> rows;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto place = refinement.vertices()[cell.vertices[i]].exact();
        Rational total = 0;
        for (std::size_t k = 0; k < 4; ++k) total += coordinate(place, k);
        for (std::size_t k = 0; k < 4; ++k) rows[i][k] = coordinate(place, k) / total;
      }
      const Rational part = determinant(rows);
      EXPECT_GT(part, 0);
      volume += part;
    }
    EXPECT_EQ(volume, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Strata, NearlyVanishing,
                         testing::Values(Stratum::cone_apex_inside, Stratum::zero_on_face,
                                         Stratum::zero_on_edge),
                         [](const auto& stratum) { return name_of(stratum.param); });

double size_at(const LevelSimplex<double, 4>& simplex, const std::array<double, 4>& weights) {
  return std::sqrt(norm_form(tensor_at(simplex.tensors, weights)));
}

TEST(SmallField, IsSmallestWhereTheSharesSay) {
  Compared compared("tetrahedra", static_cast<std::size_t>(trials(100)) / 4);
  const std::uint64_t seed = 20241304;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(100); ++trial) {
    Random random(seed + static_cast<std::uint64_t>(trial));
    const double rest = std::ldexp(1.0, -random.integer(16, 36));
    const auto tensors = nearly_in_stratum(Stratum::cone_apex_inside, rest,
                                           seed + static_cast<std::uint64_t>(trial));
    SCOPED_TRACE(exact_text(tensors));
    const SimplexCase<double, 4> tet(tensors, ModeValue::parse("1/2"));
    std::array<RefinementVertex<double, 4>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = detail::corner_vertex(tet.simplex, i);
    const auto shares = detail::shares_of_small_field<double, 4, 4>(
        {&corners[0], &corners[1], &corners[2], &corners[3]});
    // A zero next to the boundary is left to the halves.
    if (!shares) continue;
    ++compared;
    std::array<double, 4> weights;
    double total = 0;
    for (std::size_t i = 0; i < 4; ++i) total += weights[i] = static_cast<double>((*shares)[i]);
    for (auto& w : weights) w /= total;
    const double least = size_at(tet.simplex, weights);
    EXPECT_LT(least, 1e-2);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        auto moved = weights;
        moved[i] += least / 4;
        moved[k] -= least / 4;
        EXPECT_GE(size_at(tet.simplex, moved), 0.9 * least);
      }
  }
}

}  // namespace
}  // namespace tensortopo::test
