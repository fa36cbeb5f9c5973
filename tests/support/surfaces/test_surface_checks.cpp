// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "support/oracles/high_precision_mode.hpp"
#include "support/fields/random_fields.hpp"
#include "surface_checks.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

// A field whose mode depends on x alone and is -143/343 at x = 1/2, on [0, 2]^3, and the plane
// x = 1/2 as the surface: vertices are midpoints of mesh edges, hence exact.
struct Plane {
  TetMesh mesh = cube_mesh(2);
  SurfaceMesh surface;

  Plane() {
    const SymmetricTensor<double> middle{22, 4, -26, 0, 0, 0}, slope{1, -2, 1, 0, 0, 0};
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      mesh.tensors[i] = middle + (2 * mesh.points[i].x - 1) * slope;
    }
    // diag(22+t, 4-2t, -26+t): the middle value falls as t grows, so the mode rises with x.
    std::map<std::pair<Index, Index>, Index> vertex_on;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      std::vector<Index> low, high;
      for (const Index v : mesh.tets[t]) {
        (mesh.points[static_cast<std::size_t>(v)].x < 0.5 ? low : high).push_back(v);
      }
      if (low.empty() || high.empty()) continue;
      std::vector<Index> ring;
      for (std::size_t i = 0; i < low.size(); ++i) {
        for (std::size_t j = 0; j < high.size(); ++j) {
          const auto jj = i % 2 == 0 ? j : high.size() - 1 - j;  // so that the four go around
          ring.push_back(vertex(vertex_on, low[i], high[jj]));
        }
      }
      for (std::size_t k = 2; k < ring.size(); ++k) add({ring[0], ring[k - 1], ring[k]}, t);
    }
  }

  Index vertex(std::map<std::pair<Index, Index>, Index>& vertex_on, Index u, Index v) {
    const auto id = static_cast<Index>(surface.points.size());
    const auto [entry, is_new] = vertex_on.try_emplace({u, v}, id);
    if (!is_new) return entry->second;
    surface.points.push_back(0.5 * (mesh.points[static_cast<std::size_t>(u)] +
                                    mesh.points[static_cast<std::size_t>(v)]));
    surface.carrier.push_back(Carrier::edge);
    surface.carrier_id.push_back(id);
    surface.medium_eigenvector.push_back({0, 1, 0});
    surface.dominant_eigenvector.push_back({0, 0, 1});
    surface.normal.push_back({1, 0, 0});
    surface.mode.push_back(-143.0 / 343);
    surface.residual.push_back(0);
    return id;
  }

  void add(std::array<Index, 3> triangle, std::size_t tet) {
    const auto p = [&](std::size_t i) {
      return surface.points[static_cast<std::size_t>(triangle[i])];
    };
    if (cross(p(1) - p(0), p(2) - p(0)).x < 0) std::swap(triangle[1], triangle[2]);
    surface.triangles.push_back(triangle);
    surface.tet.push_back(static_cast<Index>(tet));
    surface.component.push_back(0);
  }

  void erase_triangle(std::size_t t) {
    const auto offset = static_cast<std::ptrdiff_t>(t);
    surface.triangles.erase(surface.triangles.begin() + offset);
    surface.tet.erase(surface.tet.begin() + offset);
    surface.component.erase(surface.component.begin() + offset);
  }

  // A triangle none of whose corners lies on the boundary of the square [0, 2]^2 of y and z, or
  // else the triangle nearest to the centre.
  std::size_t central_triangle() const {
    const auto distance = [&](std::size_t t) {
      double sum = 0;
      for (const Index v : surface.triangles[t]) {
        const auto& q = surface.points[static_cast<std::size_t>(v)];
        sum += std::hypot(q.y - 1, q.z - 1);
      }
      return sum;
    };
    std::size_t best = 0;
    for (std::size_t t = 1; t < surface.triangles.size(); ++t) {
      if (distance(t) < distance(best)) best = t;
    }
    return best;
  }

  SurfaceReport check(const SurfaceCheckOptions& options = {}) const {
    return check_surface(surface, mesh, options);
  }
};

// Whether some violation is of this kind.
testing::AssertionResult complains(const SurfaceReport& report, const std::string& kind) {
  for (const auto& violation : report.violations) {
    if (violation.starts_with(kind + ":")) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "no complaint of the kind '" << kind << "' in\n" << report;
}

TEST(SurfaceChecks, ASoundSurfacePasses) {
  const Plane plane;
  const SurfaceReport report = plane.check();
  EXPECT_TRUE(report.sound()) << report;
  EXPECT_EQ(report.components, std::vector{disc});
  EXPECT_EQ(report.boundary_edges, 16);
  EXPECT_EQ(report.opposed_normals, 0);
  EXPECT_EQ(report.residuals.above, 0);
  EXPECT_LT(report.residuals.largest, 1e-16);
  EXPECT_GE(report.residuals.evaluated, static_cast<int>(plane.surface.points.size()));
}

TEST(SurfaceChecks, AHoleIsAnOpenEdge) {
  Plane plane;
  plane.erase_triangle(plane.central_triangle());
  const SurfaceReport report = plane.check();
  EXPECT_TRUE(complains(report, "open edge"));
  EXPECT_EQ(report.components, std::vector{annulus});
}

TEST(SurfaceChecks, ACallerMayDecideWhatLiesOnTheBoundary) {
  Plane plane;
  SurfaceCheckOptions options;
  options.on_domain_boundary = [](Index, Index) { return false; };
  EXPECT_TRUE(complains(plane.check(options), "open edge"));
  plane.erase_triangle(plane.central_triangle());
  options.on_domain_boundary = [](Index, Index) { return true; };
  EXPECT_TRUE(plane.check(options).sound()) << plane.check(options);
}

TEST(SurfaceChecks, AFlippedTriangleBreaksTheOrientation) {
  Plane plane;
  std::swap(plane.surface.triangles[3][0], plane.surface.triangles[3][1]);
  SurfaceCheckOptions options;
  SurfaceReport report = plane.check(options);
  EXPECT_TRUE(complains(report, "orientation"));
  EXPECT_EQ(report.opposed_normals, 3);
  options.opposed_normals_are_violations = true;
  EXPECT_TRUE(complains(plane.check(options), "opposed normal"));
}

TEST(SurfaceChecks, AWholeSurfaceInsideOutIsSeen) {
  Plane plane;
  for (auto& t : plane.surface.triangles) std::swap(t[0], t[1]);
  const SurfaceReport report = plane.check();
  EXPECT_TRUE(report.sound());
  EXPECT_EQ(report.opposed_normals, static_cast<int>(3 * plane.surface.triangles.size()));
}

TEST(SurfaceChecks, AThirdTriangleAtAnEdge) {
  Plane plane;
  auto& s = plane.surface;
  const auto t = s.triangles[plane.central_triangle()];
  // Join one edge to a far vertex.
  const auto far = static_cast<Index>(s.points.size() - 1);
  ASSERT_TRUE(std::find(t.begin(), t.end(), far) == t.end());
  s.triangles.push_back({t[0], t[1], far});
  s.tet.push_back(0), s.component.push_back(0);
  EXPECT_TRUE(complains(plane.check(), "edge"));
  EXPECT_TRUE(complains(plane.check(), "vertex link"));
}

TEST(SurfaceChecks, APinchedVertexHasALinkOfTwoParts) {
  // Two triangles that touch in a corner.
  Plane plane;
  auto& s = plane.surface;
  const auto central = s.triangles[plane.central_triangle()];
  const Index v = central[0];
  std::vector<std::array<Index, 3>> around;
  for (const auto& t : s.triangles) {
    if (std::find(t.begin(), t.end(), v) != t.end()) around.push_back(t);
  }
  std::array<Index, 3> other{};
  for (const auto& t : around) {
    int shared = 0;
    for (const Index w : t) shared += std::find(central.begin(), central.end(), w) != central.end();
    if (shared == 1) other = t;
  }
  ASSERT_NE(other[0], other[1]);
  s.triangles = {central, other};
  s.tet = {0, 0}, s.component = {0, 0};
  EXPECT_TRUE(complains(plane.check(), "vertex link"));
  EXPECT_TRUE(complains(plane.check(), "unused vertex"));
}

TEST(SurfaceChecks, AVertexSplitInTwoCoincides) {
  Plane plane;
  auto& s = plane.surface;
  const std::size_t t = plane.central_triangle();
  const auto v = static_cast<std::size_t>(s.triangles[t][0]);
  s.points.push_back(s.points[v]);
  s.carrier.push_back(s.carrier[v]), s.carrier_id.push_back(s.carrier_id[v]);
  s.medium_eigenvector.push_back(s.medium_eigenvector[v]);
  s.dominant_eigenvector.push_back(s.dominant_eigenvector[v]);
  s.normal.push_back(s.normal[v]), s.mode.push_back(s.mode[v]), s.residual.push_back(0);
  s.triangles[t][0] = static_cast<Index>(s.points.size() - 1);
  EXPECT_TRUE(complains(plane.check(), "coincident vertices"));
  EXPECT_TRUE(complains(plane.check(), "open edge"));
}

TEST(SurfaceChecks, BrokenArraysAndIndices) {
  Plane plane;
  plane.surface.normal.pop_back();
  EXPECT_TRUE(complains(plane.check(), "array length"));
  Plane negative;
  negative.surface.triangles[0][1] = -1;
  EXPECT_TRUE(complains(negative.check(), "index"));
  Plane beyond;
  beyond.surface.tet[0] = static_cast<Index>(beyond.mesh.tets.size());
  EXPECT_TRUE(complains(beyond.check(), "index"));
  Plane repeated;
  repeated.surface.triangles[0][1] = repeated.surface.triangles[0][0];
  EXPECT_TRUE(complains(repeated.check(), "degenerate triangle"));
  Plane twice;
  twice.surface.triangles[1] = twice.surface.triangles[0];
  EXPECT_TRUE(complains(twice.check(), "repeated triangle"));
}

TEST(SurfaceChecks, NotANumberAndWrongLengths) {
  Plane plane;
  plane.surface.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(complains(plane.check(), "not finite"));
  Plane eigenvector;
  eigenvector.surface.medium_eigenvector[1] = {0, 0, 0};
  EXPECT_TRUE(complains(eigenvector.check(), "not a unit vector"));
}

TEST(SurfaceChecks, AWrongComponentLabel) {
  Plane plane;
  plane.surface.component[4] = 1;
  EXPECT_TRUE(complains(plane.check(), "component label"));
}

TEST(SurfaceChecks, AVertexOffTheSurfaceHasAResidual) {
  Plane plane;
  plane.surface.points[5].x += 1e-9;
  const SurfaceReport report = plane.check();
  EXPECT_TRUE(complains(report, "residual"));
  EXPECT_GT(report.residuals.above, 0);
  EXPECT_EQ(report.residuals.explained, 0);
  EXPECT_GT(report.residuals.worst_ratio, 1e5);
}

TEST(SurfaceChecks, RoundedCoordinatesExplainAResidual) {
  // At 2^40 the last place of a coordinate is 2^-12: a level whose plane lies a quarter of that
  // off has no vertices in doubles that are exact, one three quarters off has better ones.
  for (const double quarters : {1.0, 3.0}) {
    Plane plane;
    const double level =
        precise_mode(plane.mesh, 0, {0.5 + quarters * 0x1p-14, 0.25, 0.125}, 0).residual;
    for (auto& p : plane.mesh.points) p.x += 0x1p40;
    for (auto& p : plane.surface.points) p.x += 0x1p40;
    for (auto& m : plane.surface.mode) m = level;
    const SurfaceReport report = plane.check();
    EXPECT_EQ(report.residuals.above, report.residuals.evaluated);
    EXPECT_EQ(report.residuals.explained, quarters == 1 ? report.residuals.above : 0) << report;
    EXPECT_EQ(report.sound(), quarters == 1);
    EXPECT_NEAR(report.residuals.worst_ratio, quarters / 2, 1e-3);
  }
}

TEST(SurfaceChecks, AVertexOutsideItsTetrahedron) {
  Plane plane;
  auto& s = plane.surface;
  const auto v = static_cast<std::size_t>(s.triangles[plane.central_triangle()][0]);
  s.points[v].y += 1e-9;  // still on the surface
  const SurfaceReport report = plane.check();
  EXPECT_TRUE(complains(report, "outside"));
  EXPECT_EQ(report.residuals.above, 0);
}

TEST(SurfaceChecks, LongListsAreCutShort) {
  Plane plane;
  for (auto& p : plane.surface.points) p.x += 1e-9;
  SurfaceCheckOptions options;
  options.spelled_out = 2;
  const std::vector<std::string> violations = plane.check(options).violations;
  EXPECT_EQ(std::count_if(violations.begin(), violations.end(),
                          [](const std::string& v) { return v.starts_with("residual"); }),
            3);
}

TEST(PreciseMode, RoundingBoundsTheChangeUnderSmallMoves) {
  Random random(21);
  for (int trial = 0; trial < 50; ++trial) {
    const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
    const Vector3<double> p{0.2 + 0.1 * random.uniform(), 0.3, 0.1 + 0.1 * random.uniform()};
    const PreciseMode here = precise_mode(mesh, 0, p, 0);
    const double h = 1e-7;
    const double dx = (precise_mode(mesh, 0, {p.x + h, p.y, p.z}, 0).residual - here.residual) / h;
    const double dy = (precise_mode(mesh, 0, {p.x, p.y + h, p.z}, 0).residual - here.residual) / h;
    const double dz = (precise_mode(mesh, 0, {p.x, p.y, p.z + h}, 0).residual - here.residual) / h;
    EXPECT_NEAR(std::sqrt(dx * dx + dy * dy + dz * dz), here.gradient, 1e-4 * (1 + here.gradient));
    const double ulp_x = std::nextafter(p.x, 1.0) - p.x;
    EXPECT_GE(here.rounding * 1.0001, std::abs(dx) * ulp_x / 2 * 0.999);
    double sum = 0;
    for (const double b : here.barycentric) sum += b;
    EXPECT_NEAR(sum, 1, 1e-15);
  }
}

}  // namespace
}  // namespace tensortopo::test
