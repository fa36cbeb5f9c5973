// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/cases/laws.hpp"
#include "extract/cases/strata_laws.hpp"

namespace tensortopo::test {
namespace {

// The everyday laws on ten to thirty times as many fields, with other seeds.
class LongLaws : public testing::TestWithParam<const char*> {
 protected:
  bool is_near_degenerate() const {
    return std::string(GetParam()).find("99") != std::string::npos;
  }
};

// No lattice resolves the thinnest tubes.
class LongBruteForce : public LongLaws {};

TEST_P(LongBruteForce, RandomTetrahedraHaveTheTopologyThatItSees) {
  expect_agreement_with_brute_force(GetParam(), trials(is_near_degenerate() ? 600 : 3000),
                                    20250001);
}

TEST_P(LongLaws, RandomTetrahedraHaveTheSameTopologyInTwoPrecisions) {
  expect_agreement_with_fifty_digits(GetParam(), trials(is_near_degenerate() ? 40 : 400), 20250101);
}

// The last modes that doubles tell from 1 and -1, and some before them.
class LongThinnest : public testing::TestWithParam<const char*> {};

TEST_P(LongThinnest, RandomTetrahedraHaveTheSameTopologyInTwoPrecisions) {
  expect_agreement_with_fifty_digits(GetParam(), trials(15), 20250501);
}

TEST_P(LongThinnest, IndependentTensorsGiveFlawlessSurfaces) {
  expect_flawless_surfaces(GetParam(), trials(5), 2, false, 20250510);
}

INSTANTIATE_TEST_SUITE_P(Levels, LongThinnest,
                         testing::Values("0.999999999999", "0.99999999999999",
                                         "-0.9999999999999999"));

TEST_P(LongLaws, IndependentTensorsGiveFlawlessSurfaces) {
  expect_flawless_surfaces(GetParam(), trials(is_near_degenerate() ? 5 : 20), 3, false, 20250201);
}

TEST_P(LongLaws, SmoothFieldsGiveFlawlessSurfaces) {
  expect_flawless_surfaces(GetParam(), trials(20), 6, true, 20250301);
}

// In parts, so that they can be run one by one; a million with TENSORTOPO_TEST_MULTIPLIER=10, which
// is 10,000 for each part and takes some three minutes.
class LongNearStrata : public testing::TestWithParam<int> {};

TEST_P(LongNearStrata, TetrahedraAreSoundAndTheSameAtFiftyDigits) {
  constexpr std::uint64_t apart = 1000000;
  expect_sound_near_strata(trials(1000), 40,
                           20250401 + apart * static_cast<std::uint64_t>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Parts, LongNearStrata, testing::Range(0, 100));
INSTANTIATE_TEST_SUITE_P(Levels, LongLaws, testing::ValuesIn(kLevels));
INSTANTIATE_TEST_SUITE_P(NearLevels, LongLaws, testing::ValuesIn(kNearLevels));
INSTANTIATE_TEST_SUITE_P(Levels, LongBruteForce, testing::ValuesIn(kLevels));
INSTANTIATE_TEST_SUITE_P(NearLevels, LongBruteForce,
                         testing::Values("1/1000", "-1/1000", "999/1000", "-999/1000"));

}  // namespace
}  // namespace tensortopo::test
