// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "certify_case.hpp"
#include "support/compared.hpp"

namespace tensortopo::test {
namespace {

double distance_to_segment(const Vector3<double>& x, const Vector3<double>& p,
                           const Vector3<double>& q) {
  const auto d = q - p;
  const double t = std::clamp(dot(x - p, d) / dot(d, d), 0.0, 1.0);
  return length(x - (p + t * d));
}

double distance_to_triangle(const Vector3<double>& x, const std::array<Vector3<double>, 3>& p) {
  const auto n = cross(p[1] - p[0], p[2] - p[0]);
  double nearest = std::min({distance_to_segment(x, p[0], p[1]), distance_to_segment(x, p[1], p[2]),
                             distance_to_segment(x, p[2], p[0])});
  const double size = dot(n, n);
  if (size == 0) return nearest;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i)
    inside &= dot(cross(p[(i + 1) % 3] - p[i], x - p[i]), n) >= 0;
  if (inside) nearest = std::min(nearest, std::abs(dot(x - p[0], n)) / std::sqrt(size));
  return nearest;
}

/// The largest distance of the corners and centres of some triangles to a surface.
double one_sided(const SurfaceMesh& from, const std::vector<char>& counts, const SurfaceMesh& to) {
  double largest = 0;
  const auto corner = [](const SurfaceMesh& s, std::size_t i, std::size_t k) {
    return s.points[static_cast<std::size_t>(s.triangles[i][k])];
  };
  for (std::size_t i = 0; i < from.triangles.size(); ++i) {
    if (!counts[static_cast<std::size_t>(from.tet[i])]) continue;
    const auto a = corner(from, i, 0), b = corner(from, i, 1), c = corner(from, i, 2);
    for (const auto& x : {a, 0.5 * (a + b), 0.5 * (b + c), (1.0 / 3) * (a + b + c)}) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < to.triangles.size(); ++j)
        nearest = std::min(nearest, distance_to_triangle(
                                        x, {corner(to, j, 0), corner(to, j, 1), corner(to, j, 2)}));
      largest = std::max(largest, nearest);
    }
  }
  return largest;
}

std::vector<char> outside_coarse(const TetMesh& mesh, const DistanceClaim& claim) {
  std::vector<char> counts(mesh.tets.size(), 1);
  for (const auto t : claim.coarse) counts[static_cast<std::size_t>(t)] = 0;
  return counts;
}

class Distance : public testing::TestWithParam<const char*> {};

// A surface with many more samples stands for the level: its own deviation is far smaller.
TEST_P(Distance, OfAMuchFinerSurfaceStaysBelowTheBound) {
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 20241112);
  const auto coarse = certified(mesh, GetParam(), 2), fine = certified(mesh, GetParam(), 12);
  const auto& claim = coarse.level.distance;
  const auto counts = outside_coarse(mesh, claim);
  const double there = one_sided(coarse.extraction.surface, counts, fine.extraction.surface);
  const double back = one_sided(fine.extraction.surface, counts, coarse.extraction.surface);
  ASSERT_GT(there, 0);
  EXPECT_LE(there, claim.bound);
  EXPECT_LE(back, claim.bound);
}

// Where moved triangles prove nothing, parts of the tetrahedron do: of few samples, so that there
// are such tetrahedra, and each is looked at by itself.
TEST_P(Distance, OfAMuchFinerSurfaceStaysBelowTheBoundByParts) {
  Compared compared("tetrahedra with a bound by parts", 4);
  for (std::uint64_t seed = 20241112; seed < 20241116; ++seed) {
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, seed);
    const auto value = ModeValue::parse(GetParam());
    ExtractOptions options;
    options.keep_topology = true;
    options.sampling.resolution = 0.5;
    auto few = extract_mode_surface<double>(mesh, value, options);
    const auto claim = certify(PreparedField<double>(mesh), value, few, 0.1).distance;
    ASSERT_EQ(claim.coarse.size(), claim.coarse_bounds.size());
    const auto fine = certified(mesh, GetParam(), 12).extraction.surface;
    for (std::size_t i = 0; i < claim.coarse.size(); ++i) {
      const double bound = claim.coarse_bounds[i];
      EXPECT_LE(bound, claim.coarse_bound);
      if (bound > 0.9) continue;  // all edges are longer
      ++compared;
      std::vector<char> counts(mesh.tets.size(), 0);
      counts[static_cast<std::size_t>(claim.coarse[i])] = 1;
      constexpr double kOfFineOne = 0.01;
      EXPECT_LE(one_sided(few.surface, counts, fine), bound + kOfFineOne);
      EXPECT_LE(one_sided(fine, counts, few.surface), bound + kOfFineOne);
    }
  }
}

TEST_P(Distance, ShrinksWithMoreSamples) {
  const TetMesh mesh = smooth_cube(3, 20241111);
  const auto mean = [&](double resolution) {
    double sum = 0;
    const auto reach = certified(mesh, GetParam(), resolution).level.distance.reach;
    for (const int r : reach) sum += reach_length(r);
    return sum / static_cast<double>(reach.size());
  };
  const double coarse = mean(3), fine = mean(12);
  std::cout << coarse << ", with four times the samples a radian " << fine << '\n';
  EXPECT_LT(fine, coarse / 4);
}

INSTANTIATE_TEST_SUITE_P(Levels, Distance, testing::Values("0", "1/2", "-1/2", "-9/10"));

RC_GTEST_PROP(Reach, IsTheSmallestLengthOfItsGridThatSuffices, ()) {
  const int exponent = *rc::gen::inRange(-900, 900);
  const double mantissa = 1 + *rc::gen::inRange(0, 1 << 20) * 0x1p-20;
  const double wanted = std::ldexp(mantissa, exponent);
  const int n = reach_of(wanted);
  RC_ASSERT(reach_length(n) >= wanted);
  RC_ASSERT(reach_length(n - 1) < wanted);
}

}  // namespace
}  // namespace tensortopo::test
