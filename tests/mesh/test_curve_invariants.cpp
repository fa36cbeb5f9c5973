// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <stdexcept>

#include "tensortopo/mesh/curve_mesh.hpp"

namespace tensortopo {
namespace {

CurveMesh square_and_segment() {
  CurveMesh c;
  c.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {5, 3, 4}, {9, 9, 9}};
  c.lines = {{0, 1, 2}, {2, 3, 0}, {5, 4}};
  return c;
}

TEST(CurveInvariants, CountComponentsAndThoseWithoutEnds) {
  const CurveInvariants known = curve_invariants(square_and_segment());
  EXPECT_EQ(known.vertices, 6u);
  EXPECT_EQ(known.components, 2u);
  EXPECT_EQ(known.closed_components, 1u);
  EXPECT_EQ(known.length, 9);
}

TEST(CurveInvariants, DoNotDependOnHowLinesAreCut) {
  CurveMesh c = square_and_segment();
  c.lines = {{3, 0}, {5, 4}, {1, 2}, {3, 2}, {0, 1}};
  const CurveInvariants known = curve_invariants(c);
  EXPECT_EQ(known.components, 2u);
  EXPECT_EQ(known.closed_components, 1u);
  c.lines.pop_back();
  EXPECT_EQ(curve_invariants(c).closed_components, 0u);
}

TEST(CurveInvariants, OfNothingAreZero) {
  const CurveInvariants known = curve_invariants({});
  EXPECT_EQ(known.components, 0u);
  EXPECT_EQ(known.length, 0);
}

TEST(CurveInvariants, RefuseLinesOutOfRange) {
  CurveMesh c = square_and_segment();
  c.lines[0][1] = 7;
  EXPECT_THROW(curve_invariants(c), std::invalid_argument);
  c.lines[0][1] = -1;
  EXPECT_THROW(curve_invariants(c), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo
