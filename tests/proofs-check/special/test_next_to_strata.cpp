// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Next to what is special everything is general, but hard to tell from it: the checker, which goes
// its own way, must find what the extractor found.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "extract/cases/extract_case.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/fields/strata_fields.hpp"

namespace tensortopo::test {
namespace {

class NextToStrata : public testing::TestWithParam<Stratum> {};

/// At a mode that is not the stratum's own every proof closes, in both programs. At its own, within
/// 1e-9 or 1e-14 of it, the extractor may leave a tetrahedron open, and the checker what the
/// extractor proved; neither may be wrong.
TEST_P(NextToStrata, TetrahedraAreCertified) {
  const std::uint64_t seed = 20241310;
  SCOPED_TRACE(announce(seed));
  const std::string special = special_mode(GetParam());
  Court court("next_to_strata");
  int asked = 0, open = 0;
  const int count = trials(TENSORTOPO_NEXT_TO_STRATA);
  for (int trial = 0; trial < count; ++trial)
    for (const double rest : full_or_short<std::vector<double>>({0x1p-20, 0x1p-36}, {0x1p-36})) {
      const auto tensors =
          nearly_in_stratum(GetParam(), rest, seed + static_cast<std::uint64_t>(trial));
      const TetMesh mesh = reference_tet_mesh(tensors);
      SCOPED_TRACE(exact_text(tensors));
      EXPECT_EQ(court.verdict(exhibit(mesh, {"-9/10"})), "certified") << court.report();
      const std::string verdict = court.verdict(exhibit(mesh, {special.empty() ? "0" : special}));
      EXPECT_TRUE(verdict == "certified" || verdict == "undecided") << court.report();
      ++asked;
      open += verdict == "undecided";
    }
  std::cout << open << " of " << asked << " undecided at the stratum's own mode\n";
}

INSTANTIATE_TEST_SUITE_P(Strata, NextToStrata, testing::ValuesIn(all_strata()),
                         [](const auto& stratum) { return name_of(stratum.param); });

/// Below the least normal number rounding is as large as at it.
TEST(DenormalCoordinates, AreNotRefuted) {
  Court court("denormal");
  int certified = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const double z : {1e-310, 5e-324}) {
      TetMesh mesh = reference_tet_mesh(nearly_in_stratum(all_strata()[0], 1, seed));
      for (auto& p : mesh.points)
        if (p.z == 0) p.z = z;
      const std::string verdict = court.verdict(exhibit(mesh, {"0", "1/2"}));
      EXPECT_TRUE(verdict == "certified" || verdict == "undecided") << court.report();
      certified += verdict == "certified";
    }
  EXPECT_GT(certified, 12);
}

}  // namespace
}  // namespace tensortopo::test
