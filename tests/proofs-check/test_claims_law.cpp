// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "claims_law.hpp"
#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

class CertifiedClaims : public testing::TestWithParam<const char*> {};

TEST_P(CertifiedClaims, AreWhatBruteForceSees) {
  expect_claims_that_brute_force_sees(GetParam(), trials(TENSORTOPO_LAW_TETS), 20241203);
}

INSTANTIATE_TEST_SUITE_P(Levels, CertifiedClaims,
                         testing::Values("0", "1/10", "-1/2", "1/2", "-9/10"));

}  // namespace
}  // namespace tensortopo::test
