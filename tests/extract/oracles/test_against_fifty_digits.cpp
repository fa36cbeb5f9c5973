// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "extract/cases/extract_case.hpp"
#include "extract/cases/laws.hpp"

namespace tensortopo::test {
namespace {

class TetrahedraInTwoPrecisions : public testing::TestWithParam<const char*> {};

TEST_P(TetrahedraInTwoPrecisions, HaveTheSameTopology) {
  const std::string mode = GetParam();
  const bool given = mode.find("99") != std::string::npos;
  expect_agreement_with_fifty_digits(mode, trials(given ? 8 : 20), 20240101);
}

INSTANTIATE_TEST_SUITE_P(Levels, TetrahedraInTwoPrecisions, testing::ValuesIn(kLevels));

TEST(TetrahedraNextToModeZero, HaveTheSameTopologyInTwoPrecisions) {
  expect_agreement_with_fifty_digits("1/1000", trials(10), 20240102);
  expect_agreement_with_fifty_digits("-1/1000", trials(10), 20240103);
}

}  // namespace
}  // namespace tensortopo::test
