// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contours/vtk_contours.hpp"
#include "extract/cases/extract_case.hpp"
#include "tensortopo/analysis/baseline.hpp"
#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

/// The deviator of the piecewise linear field, in one of its tetrahedra.
Deviator<double> tensor_in(const TetMesh& mesh, std::size_t t, const Vector3<double>& x) {
  const auto& v = mesh.tets[t];
  const auto p = [&](std::size_t i) { return mesh.points[as_size(v[i])]; };
  const double volume = dot(cross(p(1) - p(0), p(2) - p(0)), p(3) - p(0));
  const std::array<double, 4> w{dot(cross(p(2) - p(1), p(3) - p(1)), x - p(1)) / -volume,
                                dot(cross(p(2) - p(0), p(3) - p(0)), x - p(0)) / volume,
                                dot(cross(p(3) - p(0), p(1) - p(0)), x - p(0)) / volume,
                                dot(cross(p(1) - p(0), p(2) - p(0)), x - p(0)) / volume};
  Deviator<double> sum{};
  for (std::size_t i = 0; i < 4; ++i)
    sum = sum + w[i] * deviator(mesh.tensors[as_size(v[i])]);
  return sum;
}

double mode_in(const TetMesh& mesh, std::size_t t, const Vector3<double>& x) {
  return mode_if_defined(tensor_in(mesh, t, x)).value_or(0);
}

TetMesh smooth(int cubes, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(cubes);
  fill_with_smooth_tensors(mesh, seed, 4, 2);
  return mesh;
}

class Baselines : public testing::TestWithParam<const char*> {
 protected:
  static constexpr std::uint64_t kSeed = 20241220;
};

TEST_P(Baselines, MarchingIsAManifoldThatSeparatesTheVerticesByTheirModes) {
  const TetMesh mesh = smooth(4, kSeed);
  const double mu = ModeValue::parse(GetParam()).approx();
  const auto surface = baseline_surface(Baseline::marching, mesh, ModeValue::parse(GetParam()));
  ASSERT_GT(surface.triangles.size(), 0u);
  const auto known = surface_invariants(surface);
  EXPECT_TRUE(known.manifold);
  EXPECT_TRUE(known.consistently_oriented);
  // Each triangle sees the corners of its tetrahedron with larger modes on the side of its normal.
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto corner = [&](std::size_t k) {
      return surface.points[as_size(surface.triangles[i][k])];
    };
    const auto normal = cross(corner(1) - corner(0), corner(2) - corner(0));
    const double size = std::sqrt(dot(normal, normal));
    for (const auto v : mesh.tets[as_size(surface.tet[i])]) {
      const double mode = *mode_if_defined(deviator(mesh.tensors[as_size(v)]));
      const double height = dot(normal, mesh.points[as_size(v)] - corner(0));
      if (std::abs(height) > 1e-9 * size) {
        EXPECT_EQ(height > 0, mode > mu) << i;
      }
    }
  }
}

// Both filters and ours contour the same linear function; they cut quadrangles in two as they like.
TEST_P(Baselines, VtkFiltersCoverInEachTetrahedronWhatMarchingDoes) {
  for (const TetMesh& mesh : {smooth(3, kSeed), subdivide(smooth(2, kSeed + 5))}) {
    const auto mode = ModeValue::parse(GetParam());
    const auto by_tet = [&](const SurfaceMesh& surface) {
      std::vector<Vector3<double>> area(mesh.tets.size());
      for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const auto corner = [&](std::size_t k) {
          return surface.points[as_size(surface.triangles[i][k])];
        };
        auto& sum = area[as_size(surface.tet[i])];
        sum = sum + cross(corner(1) - corner(0), corner(2) - corner(0));
      }
      return area;
    };
    const auto expected = by_tet(baseline_surface(Baseline::marching, mesh, mode));
    for (const auto filter : {VtkFilter::contour_grid, VtkFilter::contour_3d_linear_grid}) {
      const auto surface = vtk_contour(mesh, mode, filter);
      ASSERT_GT(surface.triangles.size(), 0u);
      EXPECT_TRUE(surface_invariants(surface).consistently_oriented);
      const auto found = by_tet(surface);
      for (std::size_t t = 0; t < found.size(); ++t) {
        const auto difference = found[t] - expected[t];
        EXPECT_LT(dot(difference, difference), 1e-10 * dot(expected[t], expected[t]) + 1e-14) << t;
      }
      EXPECT_EQ(vtk_triangles(mesh, mode, filter).points.size(), surface.points.size());
    }
  }
}

TEST_P(Baselines, APatchesHaveTheirVerticesOnTheLevel) {
  const TetMesh mesh = smooth(3, kSeed + 1);
  const auto mode = ModeValue::parse(GetParam());
  const auto surface = baseline_surface(Baseline::a_patches, mesh, mode);
  ASSERT_GT(surface.triangles.size(), 0u);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i])
      EXPECT_NEAR(mode_in(mesh, as_size(surface.tet[i]), surface.points[as_size(v)]),
                  mode.approx(), 1e-9);
}

// Its triangles see the larger mode where their normals point, as ours do, and cover the same area.
TEST_P(Baselines, APatchesAreTheSurfaceThatWeExtractButForCracks) {
  const TetMesh mesh = smooth(3, kSeed + 2);
  const auto mode = ModeValue::parse(GetParam());
  BaselineOptions options;
  options.samples = 8;
  const auto surface = baseline_surface(Baseline::a_patches, mesh, mode, options);
  ExtractOptions fine;
  fine.sampling.resolution = 16;
  const auto ours = extract_mode_surface<double>(mesh, mode, fine).surface;
  const double area = surface_invariants(surface).area, our_area = surface_invariants(ours).area;
  EXPECT_NEAR(area, our_area, 0.02 * our_area);
  double wrong = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto corner = [&](std::size_t k) {
      return surface.points[as_size(surface.triangles[i][k])];
    };
    const auto normal = cross(corner(1) - corner(0), corner(2) - corner(0));
    const double size = std::sqrt(dot(normal, normal));
    const auto centre = (1.0 / 3) * (corner(0) + corner(1) + corner(2));
    const double h = 1e-4;
    const auto t = as_size(surface.tet[i]);
    if (size > 0 && mode_in(mesh, t, centre + (h / size) * normal) <
                        mode_in(mesh, t, centre - (h / size) * normal))
      wrong += size / 2;
  }
  EXPECT_LT(wrong, 0.01 * area);
}

double area_of(const SurfaceMesh& surface, std::size_t i) {
  const auto corner = [&](std::size_t k) {
    return surface.points[as_size(surface.triangles[i][k])];
  };
  const auto normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  return std::sqrt(dot(normal, normal)) / 2;
}

std::vector<double> areas_by_tet(const TetMesh& mesh, const SurfaceMesh& surface) {
  std::vector<double> areas(mesh.tets.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    areas[as_size(surface.tet[i])] += area_of(surface, i);
  return areas;
}

TEST(Hybrid, HasItsVerticesOnTheNeutralSurfaceAndTheLargerModeOnTheSideOfItsNormals) {
  const TetMesh mesh = smooth(3, 20241223);
  const auto surface = baseline_surface(Baseline::hybrid, mesh, ModeValue());
  ASSERT_GT(surface.triangles.size(), 100u);
  double wrong = 0, area = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    Vector3<double> centre{};
    const auto t = as_size(surface.tet[i]);
    for (const auto v : surface.triangles[i]) {
      EXPECT_NEAR(mode_in(mesh, t, surface.points[as_size(v)]), 0, 1e-9);
      centre += (1.0 / 3) * surface.points[as_size(v)];
    }
    const auto corner = [&](std::size_t k) {
      return surface.points[as_size(surface.triangles[i][k])];
    };
    const auto normal = cross(corner(1) - corner(0), corner(2) - corner(0));
    const double size = std::sqrt(dot(normal, normal)), h = 1e-4;
    area += size / 2;
    if (size > 0 && mode_in(mesh, t, centre + (h / size) * normal) <
                        mode_in(mesh, t, centre - (h / size) * normal))
      wrong += size / 2;
  }
  EXPECT_LT(wrong, 0.01 * area);
}

// Patches take another way to the same surface, through no parameterization: what a tetrahedron
// holds must agree, singular lines included. Halving gives up where patches touch: in few of them.
TEST(Hybrid, CoversInEachTetrahedronTheAreaOfFinePatches) {
  const TetMesh mesh = smooth(3, 20241224);
  BaselineOptions options;
  options.samples = 12;
  options.halvings = 18;
  options.flatness = 1.0 / 512;
  const auto hybrid =
      areas_by_tet(mesh, baseline_surface(Baseline::hybrid, mesh, ModeValue(), options));
  const auto patches =
      areas_by_tet(mesh, baseline_surface(Baseline::a_patches, mesh, ModeValue(), options));
  double sum = 0, off = 0;
  std::size_t met = 0, different = 0;
  for (std::size_t t = 0; t < hybrid.size(); ++t) {
    const double gap = std::abs(hybrid[t] - patches[t]);
    met += patches[t] > 0;
    different += gap > 0.01 * patches[t] + 1e-6;
    sum += patches[t];
    off += gap;
  }
  EXPECT_GT(met, 20u);
  EXPECT_LT(off, 0.01 * sum);
  EXPECT_LE(different, met / 20);
}

// The field of a finer lattice is the same, so marching on it comes as close as one likes.
TEST(Hybrid, CoversTheAreaOfMarchingOnAFineLattice) {
  TetMesh mesh = smooth(2, 20241225);
  BaselineOptions options;
  options.flatness = 1.0 / 256;
  const double area =
      surface_invariants(baseline_surface(Baseline::hybrid, mesh, ModeValue(), options)).area;
  for (int i = 0; i < 4; ++i) mesh = subdivide(mesh);
  const double fine =
      surface_invariants(baseline_surface(Baseline::marching, mesh, ModeValue())).area;
  EXPECT_NEAR(area, fine, 0.01 * fine);
}

TEST(Hybrid, IsWithinItsFlatnessOfTheSurface) {
  const TetMesh mesh = smooth(3, 20241226);
  for (const double flatness : {1.0 / 8, 1.0 / 64}) {
    BaselineOptions options;
    options.flatness = flatness;
    const auto surface = baseline_surface(Baseline::hybrid, mesh, ModeValue(), options);
    // A plane's distance from the surface within: the mode at the middles of triangles, over its
    // growth along their normals.
    double off = 0, area = 0;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      Vector3<double> centre{};
      for (const auto v : surface.triangles[i])
        centre += (1.0 / 3) * surface.points[as_size(v)];
      const auto t = as_size(surface.tet[i]);
      const double h = 1e-5, mode = mode_in(mesh, t, centre);
      const Vector3<double> slope{
          (mode_in(mesh, t, centre + Vector3<double>{h, 0, 0}) - mode) / h,
          (mode_in(mesh, t, centre + Vector3<double>{0, h, 0}) - mode) / h,
          (mode_in(mesh, t, centre + Vector3<double>{0, 0, h}) - mode) / h};
      area += area_of(surface, i);
      if (std::abs(mode) > flatness * std::sqrt(3.0) * std::sqrt(dot(slope, slope)))
        off += area_of(surface, i);
    }
    EXPECT_LT(off, 0.01 * area) << flatness;
  }
}

TEST(Hybrid, OtherModesAreRefused) {
  const TetMesh mesh = smooth(1, 20241227);
  EXPECT_THROW((void)baseline_surface(Baseline::hybrid, mesh, ModeValue::parse("1/2")),
               std::invalid_argument);
}

// Of rank 3 the medium eigenvectors do not parameterize the surface: patches stand in.
TEST(Hybrid, FieldsInSpecialPositionAreLeftToPatches) {
  TetMesh mesh = smooth(2, 20241228);
  for (auto& t : mesh.tensors) t.xz = t.yz = 0;
  EXPECT_EQ(baseline_surface(Baseline::hybrid, mesh, ModeValue()).triangles.size(),
            baseline_surface(Baseline::a_patches, mesh, ModeValue()).triangles.size());
}

INSTANTIATE_TEST_SUITE_P(Levels, Baselines, testing::Values("0", "1/2", "-1/2", "9/10"));

}  // namespace
}  // namespace tensortopo::test
