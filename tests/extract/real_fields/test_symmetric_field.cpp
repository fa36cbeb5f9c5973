// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <utility>

#include "real_field_laws.hpp"

// A compressed block with exact planes of symmetry and an axis that is degenerate all along.

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

const SymmetricTensor<double>& tensor_at(const TetMesh& mesh, Index v) {
  return mesh.tensors[static_cast<std::size_t>(v)];
}

TEST(SymmetricBlock, IsDegenerateOnItsAxisAndSymmetricAcrossItsMirrors) {
  const auto& [mesh, axis] = symmetric_block();
  EXPECT_EQ(axis.size(), 13u);
  for (const Index v : axis) {
    const auto& t = tensor_at(mesh, v);
    EXPECT_TRUE(t.xx == t.yy && t.xy == 0 && t.yz == 0 && t.xz == 0);
    EXPECT_LT(t.zz, t.xx);  // pressed: of mode -1, all along
  }
  std::size_t on_mirrors = 0;
  const auto expect_mirrored = [&](bool holds) {
    EXPECT_TRUE(holds);
    ++on_mirrors;
  };
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& [p, t] = std::pair{mesh.points[v], mesh.tensors[v]};
    if (p.x == 50) expect_mirrored(t.xy == 0 && t.xz == 0);
    if (p.y == 50) expect_mirrored(t.xy == 0 && t.yz == 0);
    if (p.x == p.y) expect_mirrored(t.xx == t.yy && t.xz == t.yz);
    if (p.x + p.y == 100) expect_mirrored(t.xx == t.yy && t.xz == -t.yz);
  }
  EXPECT_EQ(on_mirrors, 4u * 11 * 13);
}

TEST(SymmetricBlock, GivesFlawlessSurfaces) {
  for (const char* mode : full_or_short<std::vector<const char*>>({"0", "-9/10"}, {"0"}))
    expect_flawless_surface_of_symmetric_block(mode);
}

TEST(SymmetricBlock, HasItsAxisAmongItsPlanarDegenerateCurves) {
  expect_axis_among_curves_of_symmetric_block(Degeneracy::planar);
}

}  // namespace
}  // namespace tensortopo::test
