// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Lies told with knowledge of the format, of which none may be certified. The rows are those of the
// table in proofs-check/certificate/FORGERIES.md.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "lies.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

/// Honest ones, three with arrays.
const std::vector<Exhibit>& exhibits() {
  static const std::vector<Exhibit> all = [] {
    std::vector<Exhibit> result = honest_exhibits();
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, 5);
    result.push_back(exhibit_with_arrays(mesh, {"1/4", "-1/2"}));
    result.push_back(exhibit_with_arrays(mesh, {"magnitude 2"}));
    result.push_back(exhibit_with_arrays(mesh, {"anisotropy 4/5"}));
    return result;
  }();
  return all;
}

TEST(DirectedForgeries, NoneIsCertified) {
  std::vector<LieRow> rows = lies_of_claims();
  for (auto more : {lies_of_optional_claims(), lies_of_files(), lies_across(), lies_of_forms(),
                    lies_of_shapes()})
    rows.insert(rows.end(), more.begin(), more.end());
  Court court("lies");
  std::map<std::string, std::size_t> told;
  std::size_t all = 0;
  Pick pick(20261123);
  const auto lies = static_cast<std::size_t>(trials(TENSORTOPO_LIES));
  for (std::size_t round = 0; all < lies; ++round) {
    for (const LieRow& row : rows) {
      // One exhibit that has something to lie about.
      for (std::size_t tries = 0; tries < exhibits().size(); ++tries) {
        const std::size_t which = (round + tries) % exhibits().size();
        Exhibit forged = exhibits()[which];
        if (!row.tell(forged, pick)) continue;
        ++told[row.field], ++all;
        EXPECT_NE(court.verdict(forged), "certified") << row.field << ", exhibit " << which << '\n'
                                                      << forged.certificate.dump();
        break;
      }
    }
    if (testing::Test::HasFailure() && round > 20) break;
    ASSERT_LT(round, 100000u);
  }
  for (const LieRow& row : rows) {
    std::cout << row.field << ": " << told[row.field] << '\n';
    EXPECT_GT(told[row.field], 0u) << row.field;
  }
  std::cout << all << " directed forgeries of " << rows.size() << " rows\n";
}

}  // namespace
}  // namespace tensortopo::test
