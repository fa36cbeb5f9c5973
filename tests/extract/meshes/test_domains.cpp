// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Domains as they come: with holes, in several parts, touching in a vertex, of any scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

Vector3<double> centre(const TetMesh& mesh, std::size_t tet) {
  Vector3<double> sum{0, 0, 0};
  for (const Index v : mesh.tets[tet]) sum += mesh.points[static_cast<std::size_t>(v)];
  return 0.25 * sum;
}

// The mesh without the tetrahedra whose centre satisfies the predicate; all points stay.
template <class Predicate>
TetMesh without(TetMesh mesh, const Predicate& is_gone) {
  const TetMesh old = mesh;
  mesh.tets.clear();
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < old.tets.size(); ++t) {
    if (is_gone(centre(old, t))) continue;
    mesh.tets.push_back(old.tets[t]);
    mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  }
  return mesh;
}

// Three cubes a side, with independent tensors: every level crosses most tetrahedra.
TetMesh cube_of_three() {
  TetMesh mesh = cube_mesh(3);
  fill_with_normal_tensors(mesh, 20261101);
  return mesh;
}

// Extent of the cube mesh, whatever its corners are.
double largest_coordinate(const TetMesh& mesh) {
  double largest = 0;
  for (const auto& p : mesh.points) largest = std::max({largest, p.x, p.y, p.z});
  return largest;
}

class Domains : public testing::TestWithParam<const char*> {};

TEST_P(Domains, WithAHoleInsideGiveFlawlessSurfaces) {
  const TetMesh whole = cube_of_three();
  const double side = largest_coordinate(whole);
  const TetMesh mesh = without(whole, [&](const Vector3<double>& c) {
    const auto inside = [&](double x) { return 3 * x > side && 3 * x < 2 * side; };
    return inside(c.x) && inside(c.y) && inside(c.z);
  });
  ASSERT_LT(mesh.tets.size(), whole.tets.size());
  const Extraction extraction = extract(mesh, GetParam());
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(flaws(extraction, mesh), "");
  EXPECT_FALSE(extraction.surface.triangles.empty());
}

TEST_P(Domains, OfTwoPartsGiveTheSurfacesOfEach) {
  const TetMesh whole = cube_of_three();
  const double side = largest_coordinate(whole);
  const auto is_left = [&](const Vector3<double>& c) { return 3 * c.x < side; };
  const auto is_right = [&](const Vector3<double>& c) { return 3 * c.x > 2 * side; };
  const TetMesh both =
      without(whole, [&](const Vector3<double>& c) { return !is_left(c) && !is_right(c); });
  const TetMesh left = without(whole, [&](const Vector3<double>& c) { return !is_left(c); });
  const TetMesh right = without(whole, [&](const Vector3<double>& c) { return !is_right(c); });
  const Extraction extraction = extract(both, GetParam());
  EXPECT_EQ(flaws(extraction, both), "");
  auto parts = summary(extract(left, GetParam()).surface).components;
  const auto others = summary(extract(right, GetParam()).surface).components;
  parts.insert(parts.end(), others.begin(), others.end());
  std::sort(parts.begin(), parts.end());
  EXPECT_EQ(summary(extraction.surface).components, parts);
}

// A valley between two ridges.
TEST_P(Domains, ThatAreNotConvexGiveFlawlessSurfaces) {
  const TetMesh whole = cube_of_three();
  const double side = largest_coordinate(whole);
  const TetMesh mesh = without(whole, [&](const Vector3<double>& c) {
    return 3 * c.z > side && 3 * c.x > side && 3 * c.x < 2 * side;
  });
  const Extraction extraction = extract(mesh, GetParam());
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(flaws(extraction, mesh), "");
  EXPECT_FALSE(extraction.surface.triangles.empty());
}

// Tensors of vertices that differ by forty powers of two: the field is the same up to the position
// of the surface, which is close to the small ones.
TEST_P(Domains, WithTensorsOfVeryDifferentSizesGiveFlawlessSurfaces) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20261102);
  Random random(20261103);
  for (auto& t : mesh.tensors) {
    const auto scale = std::ldexp(1.0, static_cast<int>(40 * random.uniform()));
    t = scale * t;
  }
  const Extraction extraction = extract(mesh, GetParam());
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(flaws(extraction, mesh, {.residuals = false}), "");
}

// A scale of the domain by a power of two moves the surface and changes nothing else.
TEST_P(Domains, OfAnyScaleGiveTheSameSurface) {
  TetMesh mesh = cube_of_three();
  const Extraction usual = extract(mesh, GetParam());
  for (const int exponent : {-300, 300}) {
    TetMesh scaled = mesh;
    for (auto& p : scaled.points) p = std::ldexp(1.0, exponent) * p;
    const Extraction other = extract(scaled, GetParam());
    EXPECT_EQ(other.surface.triangles, usual.surface.triangles) << exponent;
    ASSERT_EQ(other.surface.points.size(), usual.surface.points.size());
    for (std::size_t i = 0; i < usual.surface.points.size(); ++i)
      EXPECT_EQ(other.surface.points[i], std::ldexp(1.0, exponent) * usual.surface.points[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, Domains,
                         testing::Values("0", "1/10", "-1/2", "9/10", "-99/100"));

}  // namespace
}  // namespace tensortopo::test
