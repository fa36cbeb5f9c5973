// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// A tetrahedron of the field s3_three_small_C3D8I: beside a layer that is nearly free of stress
/// the tensors turn around, so the tube is long; how many cells it takes depends on the order of
/// vertices.
TEST(ThinTubes, AreCertifiedInSeveralOrdersOfVertices) {
  Court court("thin_tubes_in_any_order");
  const TetTensors tensors{{{-0x1.0a5ce6532b331p+4, -0x1.b95d97e97aebap-1, -0x1.787d942c0fee2p+2,
                             0x1.32p-48, -0x1.008p-47, 0x1.114c5419ae029p+3},
                            {-0x1.0ec9b88a598a1p+4, -0x1.5600b8b3d43fcp+1, -0x1.8286e58f0e37bp+2,
                             0x1.0ep-50, -0x1.64p-47, -0x1.500d1eee13c8bp+1},
                            {0x1.6196e13bdff7cp+4, -0x1.0e4342644956cp-3, -0x1.6e8dc3f6bf754p+1,
                             -0x1.fep-49, -0x1.67p-47, -0x1.8579cff563882p-2},
                            {0x1.1acb279dcad2ap+4, 0x1.746f7e31cc089p-1, -0x1.09156ea66c7b2p+1,
                             -0x1.bee3703e22987p-1, 0x1.0ed629664d618p-1, -0x1.5f7a1fa6986dbp-1}}};
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  Compared compared("orders", 6);
  std::size_t n = 0;
  do {
    if (n++ % 4 != 0) continue;
    TetTensors turned;
    for (std::size_t i = 0; i < 4; ++i) turned[i] = tensors[order[i]];
    const Exhibit shown = exhibit(reference_tet_mesh(turned), {"-9999/10000"});
    EXPECT_EQ(court.verdict(shown), "certified") << court.report();
    compared.count(!shown.surface.triangles.empty());
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace
}  // namespace tensortopo::test
