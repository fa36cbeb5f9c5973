// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>

#include "proofs-check/forgeries/forgery.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

/// At 1 - |mode| = 1e-5 a tube is some hundred times as long as it is wide. The extractor proves it
/// by the degenerate curve in it; the checker by cells that are longer along that curve than
/// across.
TEST(ThinTubes, AreCertifiedInRandomTetrahedra) {
  Court court("thin_tubes");
  Compared crossed("levels that are not empty", 6);
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const char* mode : {"99999/100000", "-99999/100000"}) {
      SCOPED_TRACE(exact_text(Random(seed).tet_tensors()) + " " + mode);
      const Exhibit shown = exhibit(reference_tet_mesh(Random(seed).tet_tensors()), {mode});
      EXPECT_EQ(court.verdict(shown), "certified") << court.report();
      crossed.count(!shown.surface.triangles.empty());
    }
}

}  // namespace
}  // namespace tensortopo::test
