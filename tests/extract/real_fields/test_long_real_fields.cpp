// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "extract/curves/degenerate_point_laws.hpp"
#include "extract/cases/extract_case.hpp"
#include "real_field_laws.hpp"

namespace tensortopo::test {
namespace {

class LongSymmetricBlock : public testing::TestWithParam<const char*> {};

TEST_P(LongSymmetricBlock, GivesFlawlessSurfaces) {
  expect_flawless_surface_of_symmetric_block(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Levels, LongSymmetricBlock,
                         testing::Values("0", "1/2", "-1/2", "9/10", "-9/10", "999/1000",
                                         "-999/1000", "999999/1000000", "-999999/1000000"));

class LongSymmetricCurves : public testing::TestWithParam<Degeneracy> {};

TEST_P(LongSymmetricCurves, HoldTheAxis) {
  expect_axis_among_curves_of_symmetric_block(GetParam());
}

TEST_P(LongSymmetricCurves, AreWhereTheCurvesOfNearbyGeneralFieldsRun) {
  expect_curves_of_symmetric_block_near_those_of_general_fields(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Kinds, LongSymmetricCurves,
                         testing::Values(Degeneracy::linear, Degeneracy::planar));

class MultiprecisionFaces : public testing::TestWithParam<const char*> {};

TEST_P(MultiprecisionFaces, ArePassedThroughAsOftenAsExactCountsSay) {
  expect_exact_counts_on_faces(GetParam(), 1000000);
}

INSTANTIATE_TEST_SUITE_P(Fields, MultiprecisionFaces, testing::Values("s1", "s2", "s3", "s4"));

class LongDegeneratePoints : public testing::TestWithParam<const char*> {};

TEST_P(LongDegeneratePoints, HaveALoopOfTheSurfaceAroundEach) {
  expect_a_loop_around_each_degenerate_point(GetParam(), trials(400), 20250701);
}

INSTANTIATE_TEST_SUITE_P(Levels, LongDegeneratePoints,
                         testing::Values("999/1000", "-999/1000", "999999/1000000",
                                         "-999999/1000000"));

}  // namespace
}  // namespace tensortopo::test
