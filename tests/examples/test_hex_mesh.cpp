// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hex_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

const SlabShape kSlab{{108, 68, 48}, 36, 12, 0.45, 8};

TetMesh with_zero_tensors(const HexMesh& mesh) {
  TetMesh tets = to_tets(mesh);
  tets.tensors.resize(tets.points.size());
  return tets;
}

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& tet : mesh.tets) {
    const auto point = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(tet[i])]; };
    sum += dot(cross(point(1) - point(0), point(2) - point(0)), point(3) - point(0)) / 6;
  }
  return sum;
}

// How many faces have one tetrahedron, and how many two; more are a failure.
std::array<int, 2> faces_by_owners(const TetMesh& mesh) {
  std::map<std::set<Index>, int> owners;
  for (const auto& tet : mesh.tets)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::set<Index> face(tet.begin(), tet.end());
      face.erase(tet[left_out]);
      ++owners[face];
    }
  std::array<int, 2> count{};
  for (const auto& [face, n] : owners) {
    EXPECT_LE(n, 2);
    ++count[n == 1 ? 0 : 1];
  }
  return count;
}

RC_GTEST_PROP(HexMesh, ABoxIsFilledByConformingPositiveTetrahedra, ()) {
  const int nx = *rc::gen::inRange(1, 6), ny = *rc::gen::inRange(1, 6),
            nz = *rc::gen::inRange(1, 6);
  const auto mesh = with_zero_tensors(box_mesh({nx, ny, nz}, {3, 2, 7}));
  RC_ASSERT(mesh.tets.size() == static_cast<std::size_t>(6 * nx * ny * nz));
  RC_ASSERT(mesh.points.size() == static_cast<std::size_t>((nx + 1) * (ny + 1) * (nz + 1)));
  RC_ASSERT(validate(mesh).empty());
  const auto [outer, inner] = faces_by_owners(mesh);
  RC_ASSERT(outer == 4 * (nx * ny + ny * nz + nz * nx));
  RC_ASSERT(2 * inner + outer == 24 * nx * ny * nz);
  RC_ASSERT(std::abs(volume(mesh) - 42) < 1e-12);
}

TEST(HexMesh, TheSlabAndItsBlockShareTheirFaces) {
  const auto hexes = slab_mesh({9, 6, 4}, 2, kSlab);
  const auto mesh = with_zero_tensors(hexes);
  EXPECT_EQ(mesh.tets.size(), 6u * (9 * 6 * 4 + 3 * 6 * 2));
  EXPECT_TRUE(validate(mesh).empty());
  // Sides of the block, of the slab, bottom and top, each quadrilateral as two triangles; the
  // slab's footprint is no boundary, and its top replaces it.
  const int sides = 2 * (9 + 6) * 4 + 2 * (3 + 6) * 2, ends = 2 * 9 * 6;
  EXPECT_EQ(faces_by_owners(mesh)[0], 2 * (sides + ends));
  EXPECT_NEAR(volume(mesh), 108 * 68 * 48 + 36 * 68 * 12, 1e-8);
}

TEST(HexMesh, FacesOfTheSlabsLatticeArePlanar) {
  const auto mesh = slab_mesh({9, 6, 4}, 2, kSlab);
  constexpr int faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const auto& hex : mesh.hexes)
    for (const auto& face : faces) {
      const auto point = [&](int i) {
        return mesh.points[static_cast<std::size_t>(hex[static_cast<std::size_t>(face[i])])];
      };
      const auto normal = cross(point(1) - point(0), point(2) - point(0));
      EXPECT_NEAR(dot(normal, point(3) - point(0)), 0, 1e-9);
    }
}

TEST(HexMesh, TheSlabsEdgesRunAtItsSlope) {
  const auto mesh = slab_mesh({9, 6, 4}, 1, kSlab);
  const auto top = highest_hexes(mesh);
  ASSERT_EQ(top.size(), 18u);
  for (const Index hex : top) {
    const auto face = top_face(mesh, hex);
    EXPECT_EQ(face[0].z, 60);
    EXPECT_NEAR((face[3].x - face[0].x) / (face[3].y - face[0].y), 0.45, 1e-12);
    for (const auto& p : face) {
      const double middle = 54 + 0.45 * (p.y - 34);
      EXPECT_LE(std::abs(p.x - middle), 18 + 1e-12);
    }
  }
}

TEST(HexMesh, OnlyTheLowLayersAreStiff) {
  const auto mesh = slab_mesh({9, 6, 12}, 1, kSlab);
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
    const double bottom = mesh.points[static_cast<std::size_t>(mesh.hexes[h][0])].z;
    EXPECT_EQ(mesh.materials[h], bottom < 8 ? 1 : 0);
  }
  EXPECT_EQ(lowest_points(mesh).size(), 70u);
}

TEST(HexMesh, ALatticeWithoutThirdsIsRefused) {
  EXPECT_THROW(slab_mesh({10, 6, 4}, 1, kSlab), std::invalid_argument);
  EXPECT_THROW(slab_mesh({9, 6, 4}, 0, kSlab), std::invalid_argument);
  EXPECT_THROW(box_mesh({0, 1, 1}, {1, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
