// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A factor of its own at each vertex makes another field, so its topology is compared with that of
// the extractor at 50 digits, and its certificate is checked.
#include <gtest/gtest.h>

#include "extract/cases/extract_case.hpp"
#include "honest_verdict.hpp"
#include "support/compared.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

class ScaledVertices : public testing::TestWithParam<Family> {};

TEST_P(ScaledVertices, HaveTheTopologyOfFiftyDigits) {
  HonestCourt court("scaled_" + name_of(GetParam()));
  const int count = trials(4);
  Compared compared("surfaces", static_cast<std::size_t>(count) / 4);
  int unresolved = 0;
  for (int number = 0; number < count; ++number) {
    const FieldCase c = field_case(GetParam(), number);
    SCOPED_TRACE(std::to_string(number) + ", mode " + c.mode);
    const Extraction quick = extract(c.mesh, c.mode), reference = extract<Real50>(c.mesh, c.mode);
    const HonestVerdict verdict = court.judge(c);
    EXPECT_TRUE(verdict.status == "certified" || verdict.status == "undecided") << verdict.report;
    if (!quick.unresolved.empty() || !reference.unresolved.empty()) {
      ++unresolved;
      continue;
    }
    EXPECT_EQ(summary(quick.surface), summary(reference.surface));
    compared.count(!quick.surface.triangles.empty());
  }
  EXPECT_LE(50 * unresolved, count);
}

INSTANTIATE_TEST_SUITE_P(Families, ScaledVertices,
                         testing::Values(Family::powers_of_two, Family::scales),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace tensortopo::test
