// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "support/fields/random_fields.hpp"
#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

double volume(const TetMesh& mesh, const std::array<TetMesh::Index, 4>& tet) {
  const auto p = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(tet[i])]; };
  return dot(p(1) - p(0), cross(p(2) - p(0), p(3) - p(0))) / 6;
}

TEST(Subdivide, CutsEachTetrahedronInEightEqualParts) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  const TetMesh fine = subdivide(mesh);
  EXPECT_TRUE(validate(fine).empty());  // positive, conforming
  ASSERT_EQ(fine.tets.size(), 8 * mesh.tets.size());
  for (std::size_t t = 0; t < fine.tets.size(); ++t) {
    EXPECT_EQ(fine.cell_ids[t], mesh.cell_ids[t / 8]);
    EXPECT_DOUBLE_EQ(volume(fine, fine.tets[t]), volume(mesh, mesh.tets[t / 8]) / 8);
  }
}

// The field of the coordinates themselves: linear, so exact at every vertex.
TEST(Subdivide, KeepsTheField) {
  TetMesh mesh = cube_mesh(2);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const auto& p = mesh.points[i];
    mesh.tensors[i] = {p.x, 2 * p.y, 3 * p.z, p.x + p.y, p.y - p.z, 1};
  }
  const TetMesh fine = subdivide(subdivide(mesh));
  for (std::size_t i = 0; i < fine.points.size(); ++i) {
    const auto& p = fine.points[i];
    const SymmetricTensor<double> expected{p.x, 2 * p.y, 3 * p.z, p.x + p.y, p.y - p.z, 1};
    EXPECT_EQ(fine.tensors[i], expected);
  }
}

}  // namespace
}  // namespace tensortopo::test
