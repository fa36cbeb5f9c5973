// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "certify_case.hpp"
#include "tensortopo/certify/reference_points.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

// The mode, to a hundred digits, of the field of a tetrahedron at a point given in decimals.
Real100 mode_at(const TetMesh& mesh, TetMesh::Index tet, const std::array<std::string, 3>& text) {
  using Point = Vector3<Real100>;
  std::array<Point, 4> p;
  std::array<Deviator<Real100>, 4> d;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto v = static_cast<std::size_t>(mesh.tets[static_cast<std::size_t>(tet)][i]);
    const auto& q = mesh.points[v];
    p[i] = {Real100(q.x), Real100(q.y), Real100(q.z)};
    const auto& s = mesh.tensors[v];
    d[i] = deviator(SymmetricTensor<Real100>{Real100(s.xx), Real100(s.yy), Real100(s.zz),
                                             Real100(s.xy), Real100(s.yz), Real100(s.xz)});
  }
  const Point x{Real100(text[0]), Real100(text[1]), Real100(text[2])};
  const auto volume = [](const Point& a, const Point& b, const Point& c, const Point& e) {
    return dot(b - a, cross(c - a, e - a));
  };
  const Real100 whole = volume(p[0], p[1], p[2], p[3]);
  const std::array<Real100, 4> w{
      volume(x, p[1], p[2], p[3]) / whole, volume(p[0], x, p[2], p[3]) / whole,
      volume(p[0], p[1], x, p[3]) / whole, volume(p[0], p[1], p[2], x) / whole};
  Deviator<Real100> t{};
  for (std::size_t i = 0; i < 4; ++i) t = t + w[i] * d[i];
  return mode(t);
}

TEST(ReferencePoints, LieOnTheLevelToThirtyDigits) {
  TetMesh random = cube_mesh(2);
  fill_with_normal_tensors(random, 11);
  for (const TetMesh& mesh : {smooth_cube(2, 7), random})
    for (const char* text : {"0", "1/2", "-99/100"}) {
      const auto value = ModeValue::parse(text);
      const auto extraction = extract_mode_surface<double>(mesh, value);
      const auto& surface = extraction.surface;
      const auto points = reference_points(mesh, surface, value);
      EXPECT_TRUE(points.unproved.empty()) << text;
      EXPECT_LT(points.bound, 1e-31);
      ASSERT_EQ(points.coordinates.size(), surface.points.size());
      // Each corner in the tetrahedron of each of its triangles: those that share it agree.
      for (std::size_t i = 0; i < surface.triangles.size(); i += 7)
        for (const auto v : surface.triangles[i]) {
          const auto& x = points.coordinates[static_cast<std::size_t>(v)];
          EXPECT_LT(abs(mode_at(mesh, surface.tet[i], x) - to_scalar<Real100>(value)),
                    Real100("1e-29"));
          const auto& p = surface.points[static_cast<std::size_t>(v)];
          EXPECT_NEAR(std::stod(x[0]), p.x, 1e-9);
          EXPECT_NEAR(std::stod(x[1]), p.y, 1e-9);
          EXPECT_NEAR(std::stod(x[2]), p.z, 1e-9);
        }
    }
}

TEST(ReferencePoints, AreNotProvedForAnotherMode) {
  // No tensor of this field is anywhere near mode -99/100 where the surface of 99/100 is; what
  // Newton's method finds from there, if anything, must not pass for proved outside the simplex.
  const TetMesh mesh = reference_tet_mesh({{{2, -1, -1, 0, 0, 0},
                                            {2, -1, -1, 0.25, 0, 0},
                                            {2, -0.5, -1.5, 0, 0, 0},
                                            {2, -1.5, -0.5, 0, 0.125, 0.25}}});
  const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse("99/100"));
  ASSERT_FALSE(extraction.surface.points.empty());
  const auto points = reference_points(mesh, extraction.surface, ModeValue::parse("-99/100"));
  EXPECT_EQ(points.unproved.size(), extraction.surface.points.size());
  EXPECT_EQ(points.bound, 0);
}

TEST(ReferencePoints, LeaveTipsOfConesAlone) {
  TetMesh mesh = reference_tet_mesh({});
  fill_with_normal_tensors(mesh, 2);
  mesh.tensors[0] = {};
  std::size_t all_tips = 0;
  for (const char* text : {"0", "1/2", "-1/2"}) {
    const auto value = ModeValue::parse(text);
    const auto extraction = extract_mode_surface<double>(mesh, value);
    const auto points = reference_points(mesh, extraction.surface, value);
    std::size_t tips = 0;
    for (const auto carrier : extraction.surface.carrier) tips += carrier == Carrier::vertex;
    EXPECT_EQ(points.unproved.size(), tips) << text;
    all_tips += tips;
  }
  EXPECT_GT(all_tips, 0u);
}

}  // namespace
}  // namespace tensortopo::test
