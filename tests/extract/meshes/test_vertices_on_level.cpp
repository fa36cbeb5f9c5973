// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "extract/cases/extract_case.hpp"
#include "support/compared.hpp"

namespace tensortopo::test {
namespace {

TetMesh unit_tet(const std::array<SymmetricTensor<double>, 4>& tensors) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tensors.assign(tensors.begin(), tensors.end());
  mesh.tets = {{0, 1, 2, 3}};
  mesh.cell_ids = {0};
  return mesh;
}

double largest_residual(const Extraction& extraction) {
  double largest = 0;
  for (const double r : extraction.surface.residual) largest = std::max(largest, std::abs(r));
  return largest;
}

// The mode of the last vertex is -1/2, to rounding, and falls from there along an edge of a part
// of a face before the edge crosses the level.
TEST(VerticesOnLevel, AlongEdgesThatLeaveTheLevelAtAnEnd) {
  const auto mesh = unit_tet({{{-1, 1, -1, 1, 1, -1},
                               {0, 1, 1, -1, -1, -1},
                               {0, 0, 0, 1, 0, 0},
                               {1, -1, 0, -1, -1, 0}}});
  const Extraction extraction = extract(mesh, "-1/2");
  ASSERT_GT(extraction.surface.triangles.size(), 0u);
  EXPECT_LT(largest_residual(extraction), 1e-12);
}

// Tensors of small whole numbers often have the mode of the level at a vertex.
TEST(VerticesOnLevel, OfTetrahedraOfSmallWholeNumbers) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> entry(-1, 1);
  Compared compared("surfaces", 400);
  for (int trial = 0; trial < 700; ++trial) {
    std::array<SymmetricTensor<double>, 4> tensors;
    for (auto& t : tensors)
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
        *x = static_cast<double>(entry(random));
    const TetMesh mesh = unit_tet(tensors);
    const Extraction extraction = extract(mesh, trial % 2 == 0 ? "-1/2" : "1/2");
    compared.count(!extraction.surface.triangles.empty());
    EXPECT_LT(largest_residual(extraction), 1e-9) << "trial " << trial;
  }
}

}  // namespace
}  // namespace tensortopo::test
