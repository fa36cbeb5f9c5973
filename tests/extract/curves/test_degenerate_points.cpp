// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <iostream>
#include <set>

#include "degenerate_point_laws.hpp"
#include "exact_degenerate_points.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/curves/points/degenerate_points_on_face.hpp"
#include "support/generators.hpp"
#include "tensortopo/extract/curve_points.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Corners = std::array<SymmetricTensor<double>, 3>;

FacePoints points_of(const Corners& corners) {
  TetMesh mesh;
  mesh.tensors.assign(corners.begin(), corners.end());
  mesh.points.resize(3);
  const ScaledField<double> field(mesh);
  return degenerate_points_on_face({ScaledTensor{corners[0], field.exponents[0]},
                                    ScaledTensor{corners[1], field.exponents[1]},
                                    ScaledTensor{corners[2], field.exponents[2]}});
}

DegenerateCount count_of(const FacePoints& face) {
  DegenerateCount count;
  for (const auto& point : face.points) ++(point.linear ? count.linear : count.planar);
  count.in_plane = face.in_plane;
  return count;
}

std::string text(const Corners& corners) {
  return exact_text(corners[0]) + "\n" + exact_text(corners[1]) + "\n" + exact_text(corners[2]);
}

/// Whether the exact count is known, and then that the extractor's is the same.
bool agrees(const Corners& corners, std::string& complaint) {
  const auto exact = exact_degenerate_points(corners);
  const FacePoints face = points_of(corners);
  DegenerateCount found = count_of(face);
  if (!exact) {
    // Excluded without a count, or named.
    if (!face.obstacle && found.in_plane != 0) complaint = "counted what does not count";
    return false;
  }
  if (exact->on_a_side) {
    if (face.obstacle != CurveObstacle::degenerate_point_on_edge) complaint = "a side not noticed";
    if (!face.concerns_linear && found.linear != exact->linear) complaint = "linear points lost";
    if (!face.concerns_planar && found.planar != exact->planar) complaint = "planar points lost";
    return true;
  }
  if (face.obstacle) complaint = std::string(name_of(*face.obstacle));
  if (found.in_plane == 0) found.in_plane = exact->in_plane;  // excluded
  if (!(found == *exact)) {
    std::ostringstream both;
    both << "found " << found << ", exactly " << *exact;
    complaint = both.str();
  }
  return true;
}

bool agrees(const TetSample& sample) {
  const Corners corners{sample.tensors[0], sample.tensors[1], sample.tensors[2]};
  std::string complaint;
  const bool known = agrees(corners, complaint);
  if (!complaint.empty()) RC_FAIL(complaint + "\n" + text(corners));
  return known;
}

RC_GTEST_PROP(DegeneratePoints, AreAsManyAsTheExactCountOnNormalTensors, ()) {
  RC_ASSERT(agrees(*normal_tet()));
}

TEST(DegeneratePoints, AreAsManyAsTheExactCountOnManyNormalTensors) {
  const std::uint64_t seed = 20250120;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::array<int, 5> seen{};
  for (int trial = 0; trial < trials(2000); ++trial) {
    const Corners corners{random.tensor(), random.tensor(), random.tensor()};
    std::string complaint;
    agrees(corners, complaint);
    EXPECT_EQ(complaint, "") << text(corners);
    ++seen[static_cast<std::size_t>(points_of(corners).in_plane)];
  }
  std::cout << seen[2] << " planes with two points, " << seen[4] << " with four\n";
  EXPECT_EQ(seen[2] + seen[4], trials(2000));
}

RC_GTEST_PROP(DegeneratePoints, AreAsManyAsTheExactCountOnSmallIntegers, ()) {
  const int bound = *rc::gen::inRange(1, 10);
  RC_CLASSIFY(agrees(*small_integer_tet(bound)), "counted");
}

// Near planes of symmetry whole conics are nearly degenerate, and doubles cannot count.
RC_GTEST_PROP(DegeneratePoints, AreAsManyAsTheExactCountNearSpecialPosition, ()) {
  const TetSample special = *small_integer_tet(3), noise = *normal_tet();
  const bool symmetric = *rc::gen::arbitrary<bool>();
  const double size = std::ldexp(1.0, -*rc::gen::inRange(10, 60));
  TetSample sample = special;
  for (std::size_t i = 0; i < 4; ++i) {
    if (symmetric) sample.tensors[i].xz = sample.tensors[i].yz = 0;
    sample.tensors[i] = sample.tensors[i] + size * noise.tensors[i];
  }
  RC_CLASSIFY(agrees(sample), "counted");
}

// Of a uniaxial field with a few digits, oblique to the axes, minors are far below doubles'
// roundings: rows reduced by each other settle them without more digits.
TEST(DegeneratePoints, OfRoundedUniaxialTensorsAreCountedInDoubles) {
  const std::uint64_t seed = 20261124;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int points = 0, exact = 0;
  const int count = trials(400);
  for (int trial = 0; trial < count; ++trial) {
    const SymmetricTensor<double> t = random.tensor();
    const Vector3<double> e{1 + t.xx, 2 + t.yy, 3 + t.zz};
    const double size = std::ldexp(1.0, -10 - trial % 20);
    Corners corners;
    for (auto& corner : corners) {
      const double s = 1 + std::abs(random.tensor().xx);
      corner = s * SymmetricTensor<double>{e.x * e.x, e.y * e.y, e.z * e.z,
                                           e.x * e.y, e.y * e.z, e.x * e.z};
      for (double* x : {&corner.xx, &corner.yy, &corner.zz, &corner.xy, &corner.yz, &corner.xz})
        *x = size * std::round(*x / size);
    }
    std::string complaint;
    agrees(corners, complaint);
    EXPECT_EQ(complaint, "") << text(corners);
    const FacePoints face = points_of(corners);
    points += static_cast<int>(face.points.size());
    exact += face.exact;
  }
  std::cout << points << " points, " << exact << " of " << count << " by more digits\n";
  EXPECT_GT(points, count / 20);
  EXPECT_LT(exact, count / 20);
}

// Each point is a degenerate tensor, up to rounding, of the kind that it says.
RC_GTEST_PROP(DegeneratePoints, AreDegenerateTensors, ()) {
  const TetSample sample = *normal_tet();
  const Corners corners{sample.tensors[0], sample.tensors[1], sample.tensors[2]};
  TetMesh mesh;
  mesh.tensors.assign(corners.begin(), corners.end());
  const ScaledField<double> field(mesh);
  for (const auto& point : points_of(corners).points) {
    Deviator<double> t{};
    for (std::size_t i = 0; i < 3; ++i) {
      RC_ASSERT(point.weights[i] > 0);
      t = t + static_cast<double>(point.weights[i]) * field.tensors[i];
    }
    RC_ASSERT(std::abs(mode(t) - (point.linear ? 1 : -1)) < 1e-9);
    const double angle = lode_angle(t) - (point.linear ? 0 : std::acos(-1.0) / 3);
    RC_ASSERT(std::abs(angle) < 1e-8);
  }
}

RC_GTEST_PROP(DegeneratePoints, ChangeKindAndNothingElseWhenAllSignsChange, ()) {
  const TetSample sample = *normal_tet();
  Corners corners{sample.tensors[0], sample.tensors[1], sample.tensors[2]}, opposite;
  for (std::size_t i = 0; i < 3; ++i) opposite[i] = -1.0 * corners[i];
  const FacePoints one = points_of(corners), other = points_of(opposite);
  RC_ASSERT(one.points.size() == other.points.size());
  DegenerateCount turned = count_of(other);
  std::swap(turned.linear, turned.planar);
  RC_ASSERT(turned == count_of(one));
}

RC_GTEST_PROP(DegeneratePoints, DoNotDependOnTheOrderOfTheCornersOrPowersOfTwo, ()) {
  const TetSample sample = *normal_tet();
  const Corners corners{sample.tensors[0], sample.tensors[1], sample.tensors[2]};
  Corners other{corners[2], corners[0], corners[1]};
  for (auto& t : other) t = std::ldexp(1.0, *rc::gen::inRange(-900, 900)) * t;
  RC_ASSERT(count_of(points_of(corners)) == count_of(points_of(other)));
}

TEST(DegeneratePoints, OfWitnessPlanesAreAsManyAsTheExactCount) {
  for (const auto& witness : planar_witnesses()) {
    std::string complaint;
    agrees(witness.corners(), complaint);
    EXPECT_EQ(complaint, "") << witness.name;
  }
}

TEST(DegeneratePoints, HaveALoopOfTheSurfaceAroundEach) {
  using Modes = std::vector<const char*>;
  for (const char* mode :
       full_or_short<Modes>({"999/1000", "-999/1000", "999999/1000000", "-999999/1000000"},
                            {"-999/1000", "999999/1000000"}))
    expect_a_loop_around_each_degenerate_point(mode, trials(8), 20250121);
}

SymmetricTensor<double> along(double x, double y, double z) {
  return {x * x, y * y, z * z, x * y, y * z, x * z};
}

TEST(DegeneratePoints, SpecialPositionsAreNamed) {
  const SymmetricTensor<double> a{1, -1, 0, 2, 0, 0}, b{2, 1, -3, -1, 0, 0}, c{0, 3, -3, 1, 0, 0};
  // A common eigenvector z: the points with dominant eigenvectors across z fill a conic.
  EXPECT_EQ(points_of({a, b, c}).obstacle, CurveObstacle::degenerate_conic_on_face);
  EXPECT_EQ(points_of({a, b, a + b}).obstacle, CurveObstacle::dependent_tensors_on_face);
  // A linear degenerate tensor at a corner, and in the middle of a side.
  const SymmetricTensor<double> p{3, 1, -4, 2, 1, -1}, q{1, -2, 1, 3, 2, 5};
  EXPECT_EQ(points_of({along(1, 2, 3), p, q}).obstacle, CurveObstacle::degenerate_point_on_edge);
  EXPECT_EQ(points_of({along(1, 2, 3) + p, along(1, 2, 3) - p, q}).obstacle,
            CurveObstacle::degenerate_point_on_edge);
  const FacePoints corner = points_of({along(1, 2, 3), p, q});
  EXPECT_TRUE(corner.concerns_linear && !corner.concerns_planar);
  // The same planes, but triangles far from these points: nothing is named.
  const double far = 64;
  EXPECT_FALSE(points_of({far * q + along(1, 2, 3), far * q + p, q}).obstacle);
}

TEST(DegeneratePoints, NamesAreDistinct) {
  std::set<std::string_view> names;
  for (int i = 0; i < 11; ++i) names.insert(name_of(static_cast<CurveObstacle>(i)));
  EXPECT_EQ(names.size(), 11u);
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace tensortopo::test
