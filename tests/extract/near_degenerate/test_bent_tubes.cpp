// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>

#include "extract/cases/extract_case.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

// The degenerate curve bends by many times the thickness of a tube: rings follow it, so that triangles
// are beside the curve, and no other mesher is needed.
TEST(BentTubes, AreMeshedAsRingsThatFollowTheCurve) {
  const std::uint64_t seed = 20261127;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::size_t tubes = 0, others = 0, crossed = 0, not_embedded = 0;
  for (int trial = 0; trial < trials(40, 20); ++trial) {
    const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
    for (const char* mode : {"999999999/1000000000", "-99999999/100000000"}) {
      const auto extraction = extract(mesh, mode);
      const auto& done = extraction.statistics;
      EXPECT_TRUE(extraction.unresolved.empty()) << mode;
      tubes += done.sheets_tubes;
      others += done.sheets_dominant + done.sheets_subdivision + done.sheets_loops;
      crossed += done.tets_crossed;
      not_embedded += extraction.not_embedded.size();
    }
  }
  std::cout << tubes << " tubes of rings, " << others << " others; " << not_embedded << " of " << crossed
            << " tetrahedra with defects\n";
  EXPECT_GT(crossed, 20u);
  EXPECT_LE(3 * others, tubes);
  EXPECT_LE(4 * not_embedded, crossed);
}

}  // namespace
}  // namespace tensortopo::test
