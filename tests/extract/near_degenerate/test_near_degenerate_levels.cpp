// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

#include "extract/cases/curved_tet.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/cases/laws.hpp"
#include "extract/level/exact_tensors.hpp"
#include "extract/level/segment_root.hpp"
#include "extract/topology/near_degenerate_sheets.hpp"
#include "extract/topology/regions/counted_sheets.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/known_gaps.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/predicate_counts.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo::test {
namespace {

// Levels next to modes -1 and 1, where surfaces are thin tubes around degenerate curves.
class ThinLevels : public testing::TestWithParam<const char*> {};

TEST_P(ThinLevels, HaveTheSameTopologyInTwoPrecisions) {
  expect_agreement_with_fifty_digits(GetParam(), trials(15), 20250501);
}

TEST_P(ThinLevels, OfIndependentTensorsAreFlawless) {
  expect_flawless_surfaces(GetParam(), trials(1), 2, false, 20250510);
}

TEST_P(ThinLevels, OfSmoothFieldsAreFlawless) {
  expect_flawless_surfaces(GetParam(), trials(4), 3, true, 20250520);
}

INSTANTIATE_TEST_SUITE_P(Levels, ThinLevels,
                         testing::Values("999/1000", "-9999/10000", "999999/1000000",
                                         "-999999999/1000000000"));

TEST(ThinLevel, HasTheTopologyThatBruteForceSees) {
  expect_agreement_with_brute_force("997/1000", trials(60), 20250530);
}

// Where the tubes are just thick enough for it, a refinement at the level itself has the last word.
TEST(ThinLevel, HasTheSheetsThatARefinementFinds) {
  const std::uint64_t seed = 20250540;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0, tubes = 0, several = 0, no_tubes = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    for (const char* mode : {"996/1000", "-998/1000"}) {
      const CurvedTet c(tensors, ModeValue::parse(mode));
      ASSERT_TRUE(c.has_curves) << exact_text(tensors);
      auto proved = prove_cell(c.tet, c.simplex_case.level);
      ASSERT_TRUE(proved) << mode << '\n' << exact_text(tensors);
      const auto sheets = proved->sheets;
      if (sheets.empty()) continue;
      proved->subdivision.reset();
      if (!add_subdivision(c.tet, c.simplex_case.level, *proved)) continue;
      ++compared;
      (proved->tubes.empty() ? no_tubes : tubes) += proved->refined ? 1 : 0;
      several += sheets.size() > 1 ? 1 : 0;
      EXPECT_EQ(in_order(sheets), in_order(proved->sheets)) << mode << '\n' << exact_text(tensors);
    }
  }
  std::cout << compared << " compared, " << tubes << " of them tubes, " << no_tubes
            << " other refined ones, " << several << " with several sheets\n";
  EXPECT_GT(tubes, compared / 4);
  EXPECT_GT(no_tubes, compared / 50);
  EXPECT_GT(several, compared / 20);
}

// Between two levels without a critical value nothing changes, on edges as well as inside.
TEST(ThinLevel, HasTheTopologyOfEveryLevelWithoutACriticalValueInBetween) {
  const std::uint64_t seed = 20250550;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0;
  for (int trial = 0; trial < trials(10); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    for (const std::string sign : {"", "-"}) {
      const std::string own = sign + "999999/1000000";
      constexpr double gap_of_own = 1 - 0.999999 * 0.999999;
      // The nearest critical value above the level, found otherwise than the extractor does.
      const LongTensors field = field_of(tensors);
      const auto saddle = characteristic_tensor(TetrahedronField<Real50>{field});
      ASSERT_TRUE(saddle) << exact_text(tensors);
      auto gaps = known_gaps(field, sign.empty() ? 1 : -1);
      gaps.push_back(static_cast<double>(saddle->mode * saddle->mode));
      double open_until = 0.3;
      for (const double gap : gaps)
        if (gap >= 0.9 * gap_of_own) open_until = std::min(open_until, gap);
      const LocalTopology seen = topology_in_tet(extract(mesh, own));
      for (const char* other : {"99999/100000", "9999/10000", "999/1000", "99/100", "9/10"}) {
        const ModeValue mode = ModeValue::parse(sign + other);
        if (1 - mode.approx() * mode.approx() >= 0.99 * open_until) break;
        const Extraction there = extract(mesh, mode.text());
        if (!there.unresolved.empty()) continue;
        ++compared;
        EXPECT_EQ(topology_in_tet(there), seen) << sign << other << '\n' << exact_text(tensors);
      }
    }
  }
  std::cout << compared << " levels compared\n";
  EXPECT_GT(compared, trials(10));
}

// What the critical points of one side and paths in the superlevel set decide is what a refinement
// finds.
TEST(ThinLevel, HasTheSheetsThatItsCriticalPointsCount) {
  const std::uint64_t seed = 20250560;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int compared = 0, discs = 0, annuli = 0, several = 0;
  for (int trial = 0; trial < trials(250); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    for (const char* mode : {"1/2", "99/100", "-997/1000"}) {
      const CurvedTet c(tensors, ModeValue::parse(mode));
      if (!c.has_curves) continue;
      const auto& level = c.simplex_case.level;
      auto proved = prove_cell(c.tet, level);
      if (!proved || proved->loops.empty()) continue;
      const auto counted = detail::counted_sheets(
          c.tet, cell_critical_points(detail::exact_tensors(c.tet.simplex)), level, proved->loops);
      if (!counted) continue;
      proved->subdivision.reset();
      if (!add_subdivision(c.tet, level, *proved)) continue;
      ++compared;
      several += counted->size() > 1 ? 1 : 0;
      for (const auto& sheet : *counted)
        (sheet.loops.size() == 1 ? discs : annuli) += sheet.loops.size() <= 2 ? 1 : 0;
      EXPECT_EQ(in_order(*counted), in_order(proved->sheets)) << mode << '\n'
                                                              << exact_text(tensors);
    }
  }
  std::cout << compared << " compared, " << discs << " discs, " << annuli << " annuli, " << several
            << " with several sheets\n";
  EXPECT_GT(compared, trials(100));
  EXPECT_GT(annuli, trials(2));
  EXPECT_GT(several, trials(5));
}

struct NextToCurve {
  const char* mode;
  TetTensors tensors;
  std::vector<std::pair<std::size_t, int>> sheets;  ///< loops and Euler characteristic, ascending
};

// Tetrahedra of simulated stresses that the degenerate curve leaves next to an edge, or that are
// nearly degenerate along a plane of symmetry: cells as small as tubes are thin would be too many.
TEST(ThinLevel, IsSettledNextToEdgesAndPlanesOfSymmetry) {
  const std::vector<NextToCurve> witnesses{
      {"999999999/1000000000",
       {{{1.0037896746080095, 1.0358045513328964, 18.191543301727222, -0.082636207668618955,
          0.49382996422066272, -4.0804880694496051},
         {0.40190404892910114, 0.43650232728088434, 17.513903786406065, -0.045730082707095818,
          0.52455543975606767, -2.1885950155173419},
         {0.40288074787648986, 0.41765158711556155, 17.556054885403956, 1.3663473564379247e-13,
          1.4371628886955534e-12, -2.1947537300456412},
         {0.23894763943711994, -1.0430950427131143, 16.021411800914084, 1.6435594205055359e-13,
          -2.1122409377127838e-12, -1.8412136871046823}}},
       {{2, 0}}},
      {"999999999/1000000000",
       {{{-1.3023256541692472, -1.346197369193217, 44.896465495448986, -1.1736232645442879e-12,
          4.4670656063061642e-12, 1.1430861502820482},
         {-1.4113605985924513, -1.3684046855643119, 45.42158697951583, -6.0189700445967276e-13,
          4.4377695962438679e-12, -0.43356703473527647},
         {-1.41886642283043, -1.3233735859313172, 45.184515390398118, -0.005411179036488389,
          -1.5519943395962081, -0.43506776948371639},
         {-1.1437375310026496, -1.1425340927639696, 48.50210719374936, -0.0026042608182084131,
          -1.7313736577406362, -0.3602241338195355}}},
       {{1, 1}, {2, 0}}},
      {"-999999999/1000000000",
       {{{-1.8055704445676792, -1.8005913653635361, -11.023835746940918, 0.0067443496014057466,
          0.18305541661827329, -0.36604921084337505},
         {-1.4736711730227641, -1.4736711730228456, -11.353470347035461, 0.0039906753690106987,
          0.18887289166100402, -0.18887289156325143},
         {-1.8025457225720014, -1.8025457225719308, -11.055453213022568, 0.0034059642404390064,
          0.18387179598683076, -0.18387179606819312},
         {-1.4723180556402635, -1.4778388119325909, -11.31892553514276, 0.0079021803057359469,
          0.37571201427013845, -0.18795303530085919}}},
       {{2, 0}}},
  };
  for (const auto& witness : witnesses) {
    const CurvedTet c(witness.tensors, ModeValue::parse(witness.mode));
    ASSERT_TRUE(c.has_curves) << exact_text(witness.tensors);
    const auto proved = prove_cell(c.tet, c.simplex_case.level);
    ASSERT_TRUE(proved) << exact_text(witness.tensors);
    std::vector<std::pair<std::size_t, int>> sheets;
    for (const auto& sheet : proved->sheets)
      sheets.emplace_back(sheet.loops.size(), sheet.euler_characteristic);
    std::sort(sheets.begin(), sheets.end());
    EXPECT_EQ(sheets, witness.sheets) << exact_text(witness.tensors);
  }
}

// Doubles cannot tell on which side of such a level a place is; multiprecision can, and rationals
// would take many times as long.
TEST(ThinLevel, NeedsNoRationalsForSidesThatFiftyDigitsTell) {
  TetMesh mesh = cube_mesh(2);
  PredicateCounts all;
  for (const std::uint64_t seed : {2u, 3u}) {
    fill_with_smooth_tensors(mesh, seed);
    const PredicateCounts before = predicate_counts();
    extract_mode_surface<double>(mesh, ModeValue::parse("0.999999999999"));
    const PredicateCounts now = predicate_counts() - before;
    all.multiprecision += now.multiprecision, all.exact += now.exact;
  }
  EXPECT_GT(all.multiprecision, 100u);
  EXPECT_EQ(all.exact, 0u);
}

// At the mode next to 1 doubles err by as much as modes differ. What only seems to cross the level
// must not be divided for ever, nor have its curves meshed in noise.
TEST(ThinLevel, IsFoundAtTheModeNextToOne) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 1);
  std::size_t crossed = 0, unresolved = 0;
  const PredicateCounts before = predicate_counts();
  Share share(2);
  for (const char* mode : {"-0.9999999999999999", "0.9999999999999999"}) {
    if (!share.has("mode")) continue;
    const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse(mode));
    crossed += extraction.statistics.tets_crossed;
    unresolved += extraction.unresolved.size();
  }
  const PredicateCounts made = predicate_counts() - before;
  std::cout << crossed << " tetrahedra, " << unresolved << " unresolved, " << made.multiprecision
            << " signs in longer numbers\n";
  EXPECT_GT(crossed, 0u);
  EXPECT_EQ(unresolved, 0u);
  EXPECT_LT(made.multiprecision, 1000 * (crossed + unresolved));
}

// The offset from the degenerate curve is of first order where 1 - mode^2 is of second.
TEST(ThinLevel, IsMetByDoublesWhereFiftyDigitsMeetIt) {
  Compared compared("roots", static_cast<std::size_t>(trials(100)));
  const std::uint64_t seed = 20250550;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (const char* mode :
       {"0.99999999999", "0.9999999999999", "0.999999999999999", "0.9999999999999999"}) {
    const auto value = ModeValue::parse(mode);
    const auto level = make_level<double>(value);
    const auto multiprecision = make_level<Real50>(value);
    for (int trial = 0; trial < trials(100); ++trial) {
      // Dominant along z; two or three radii of the tube away from it.
      const double radius = std::sqrt(1 - level.mu_squared), size = radius * (2 + random.uniform());
      const Deviator<double> above{0, -1, 0, 0, 0};
      const Deviator<double> below{above.a + size * random.normal(),
                                   above.b + size * random.normal(), size * random.normal(),
                                   size * random.normal(), size * random.normal()};
      const auto in_multiprecision = [](const Deviator<double>& t) {
        return Deviator<Real50>{t.a, t.b, t.xy, t.yz, t.xz};
      };
      const auto from = in_multiprecision(below), to = in_multiprecision(above);
      if (side_of_level(from, multiprecision) != Verdict::negative) continue;
      ++compared;
      EXPECT_NEAR(segment_root(below, above, level),
                  static_cast<double>(segment_root(from, to, multiprecision)), 1e-12)
          << mode << ", trial " << trial;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
