// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "support/compared.hpp"
#include "tensortopo/mesh/unmatched_faces.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "plain_mesh.hpp"

namespace tensortopo {
namespace {

TetMesh mesh_of(std::vector<Vector3<double>> points, std::vector<std::array<int, 4>> tets) {
  TetMesh mesh = plain_mesh(std::move(points), std::move(tets));
  repair_orientation(mesh);
  return mesh;
}

std::size_t pairs(const TetMesh& mesh) {
  std::vector<OuterFace> outer;
  EXPECT_TRUE(validate(mesh, &outer).empty());
  return unmatched_faces(mesh, outer).size();
}

/// A square in the plane x = 0, with a tip on either side.
const std::vector<Vector3<double>> square{{0, 0, 0}, {0, 1, 0},       {0, 1, 1},
                                          {0, 0, 1}, {-1, 0.5, 0.25}, {1, 0.5, 0.25}};

TetMesh with_diagonals(bool same) {
  return same ? mesh_of(square, {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 5}, {0, 2, 3, 5}})
              : mesh_of(square, {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 3, 5}, {1, 2, 3, 5}});
}

/// A triangle in the plane x = 0 with one cell on the left, and with two on the right, around a
/// vertex in the middle of an edge.
TetMesh with_hanging_node(double off) {
  return mesh_of({{0, 0, 0}, {0, 4, 0}, {0, 1, 3}, {off, 2, 0}, {-1, 1, 1}, {1, 1, 1}},
                 {{0, 1, 2, 4}, {0, 3, 2, 5}, {3, 1, 2, 5}});
}

TEST(UnmatchedFaces, AreThoseOfBothDiagonals) {
  EXPECT_EQ(pairs(with_diagonals(true)), 0u);
  EXPECT_EQ(pairs(with_diagonals(false)), 4u);
}

TEST(UnmatchedFaces, AreBothSidesOfACrackOfCopiedVertices) {
  TetMesh whole = mesh_of(square, {{0, 1, 2, 4}, {0, 1, 2, 5}});
  EXPECT_EQ(pairs(whole), 0u);
  whole.points.insert(whole.points.end(), {square[0], square[1], square[2]});
  whole.tensors.resize(whole.points.size());
  for (const std::array<int, 4>& other :  // one, two and three copies
       {std::array{6, 1, 2, 5}, std::array{6, 7, 2, 5}, std::array{6, 7, 8, 5}}) {
    whole.tets[1] = other;
    repair_orientation(whole);
    EXPECT_EQ(pairs(whole), 1u);
  }
}

TEST(UnmatchedFaces, AreThoseAroundAHangingNodeInTheirPlane) {
  EXPECT_EQ(pairs(with_hanging_node(0)), 2u);
  EXPECT_EQ(pairs(with_hanging_node(0x1p-60)), 0u) << "a gap of this width";
}

TEST(UnmatchedFaces, AreNoneWhereCellsTouchInVerticesAndEdges) {
  const std::vector<Vector3<double>> points{{0, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 0, 0},
                                            {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 1}};
  // In the plane x = 0: an edge in common, a vertex, or nothing, from both sides and from one.
  EXPECT_EQ(pairs(mesh_of(points, {{0, 1, 2, 3}, {0, 1, 5, 6}})), 0u);
  EXPECT_EQ(pairs(mesh_of(points, {{0, 1, 2, 3}, {0, 4, 5, 6}})), 0u);
  EXPECT_EQ(pairs(mesh_of(points, {{0, 1, 2, 3}, {0, 1, 5, 3}})), 0u);
  EXPECT_EQ(pairs(mesh_of(points, {{1, 7, 2, 3}, {0, 4, 5, 6}})), 0u);
  EXPECT_EQ(pairs(mesh_of(points, {{1, 7, 2, 3}, {0, 1, 2, 6}})), 0u);
  EXPECT_EQ(pairs(mesh_of(points, {{0, 1, 7, 3}, {0, 1, 2, 6}})), 1u) << "these overlap";
}

/// However the vertices are numbered and the mesh is turned, and whatever its size.
TEST(UnmatchedFaces, DoNotDependOnNumbersAxesAndScale) {
  test::Compared compared("meshes", 100);
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    TetMesh mesh = i % 2 == 0 ? with_diagonals(false) : with_hanging_node(0);
    const std::size_t expected = pairs(mesh);
    std::vector<int> name(mesh.points.size());
    std::iota(name.begin(), name.end(), 0);
    std::shuffle(name.begin(), name.end(), random);
    const TetMesh before = mesh;
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 600) - 300);
    // A plane that is in no direction of an axis: of integers, so without rounding.
    const int a = static_cast<int>(random() % 7) - 3, b = static_cast<int>(random() % 7) - 3;
    for (std::size_t v = 0; v < name.size(); ++v) {
      const auto& p = before.points[v];
      const Vector3<double> q{p.x + a * p.y, p.y + b * p.z, p.z + a * b * p.x};
      const Vector3<double> turned = i % 3 == 0 ? q : Vector3<double>{q.z, q.x, q.y};
      mesh.points[static_cast<std::size_t>(name[v])] = scale * turned;
    }
    for (auto& tet : mesh.tets) {
      for (int& v : tet) v = name[static_cast<std::size_t>(v)];
      std::shuffle(tet.begin(), tet.end(), random);
    }
    std::shuffle(mesh.tets.begin(), mesh.tets.end(), random);
    repair_orientation(mesh);
    if (!validate(mesh).empty()) continue;  // the shear has made a cell flat
    ++compared;
    EXPECT_EQ(pairs(mesh), expected) << i;
  }
}

}  // namespace
}  // namespace tensortopo
