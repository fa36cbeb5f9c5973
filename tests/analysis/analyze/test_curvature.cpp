// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "analyze/curvature/surface_curvature.hpp"
#include "analysis/analyze/level_cells.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

// Eigenvalues 1 + r, 1 - r and -2 of [[1+x, y, 0], [y, 1-x, 0], [0, 0, -2]]: the mode depends on
// r = |(x, y)| alone, and rises until r = 3. Levels are cylinders of radius r around the z axis.
const LinearField kRing{{1, 1, -2, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {}};
// z times the ring at (x / z, y / z): levels are cones r = a z.
const LinearField kCone{{}, {1, -1, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {1, 1, -2, 0, 0, 0}};
// [[1+y, x, 0], [x, -2y, z], [0, z, y-1]].
const LinearField kCubic{
    {1, 0, -1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {1, -2, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}};

TEST(LevelCurvature, OfACylinderIsThatOfItsCircle) {
  for (const double r : {0.25, 1.0, 2.0, 3.5}) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto k = cell_of<double>(kRing).at({r * c, r * s, 0.3});
    ASSERT_TRUE(k);
    // Beyond r = 3 the mode falls with r: the normal points inward.
    const double out = r < 3 ? 1 : -1;
    EXPECT_NEAR(k->normal.x, out * c, 1e-12);
    EXPECT_NEAR(k->normal.y, out * s, 1e-12);
    EXPECT_NEAR(k->principal[out > 0 ? 0 : 1], out / r, 1e-12);
    EXPECT_NEAR(k->principal[out > 0 ? 1 : 0], 0, 1e-12);
    EXPECT_NEAR(std::abs(k->directions[out > 0 ? 1 : 0].z), 1, 1e-12);
    EXPECT_NEAR(k->gauss(), 0, 1e-12);
  }
}

// Across a cone r = a z the curvature is that of the circle, 1 / r, times the cosine of the angle
// between its plane and the normal, 1 / sqrt(1 + a^2); along its lines it is zero.
TEST(LevelCurvature, OfAConeIsThatOfItsCirclesTilted) {
  for (const double a : {0.5, 1.0, 2.5}) {
    const double z = 1.5, r = a * z;
    const auto k = cell_of<double>(kCone).at({r * 0.6, r * 0.8, z});
    ASSERT_TRUE(k);
    EXPECT_NEAR(k->principal[0], 1 / (r * std::sqrt(1 + a * a)), 1e-12);
    EXPECT_NEAR(k->principal[1], 0, 1e-12);
    const Vector3<double> ray{r * 0.6, r * 0.8, z};
    const double along = dot(k->directions[1], ray) / std::sqrt(dot(ray, ray));
    EXPECT_NEAR(std::abs(along), 1, 1e-12);
  }
}

// The neutral surface is the zero set of F = det = 2y - 2y^3 - z^2 - y z^2 + x^2 - y x^2, which is
// bent both ways. With g its gradient and H its Hessian, the mean curvature is
// (|g|^2 tr H - g.Hg) / (2 |g|^3) and the Gauss curvature g.adj(H)g / |g|^4 (R. Goldman, Curvature
// formulas for implicit curves and surfaces, 2005; the normal is g / |g|).
template <class Scalar>
void expect_implicit_curvature(double tolerance) {
  using std::abs, std::sqrt;
  for (const auto& [a, b] : {std::array{1, 2}, {-2, 1}, {3, 1}, {0, 3}}) {
    const Scalar x = Scalar(a) / Scalar(2), y = Scalar(b) / Scalar(4), one(1), two(2);
    const Scalar z = sqrt((two * y - two * y * y * y + x * x - y * x * x) / (one + y));
    const auto k = cell_of<Scalar>(kCubic).at({x, y, z});
    ASSERT_TRUE(k);
    const Vector3<Scalar> g{two * x * (one - y), two - Scalar(6) * y * y - z * z - x * x,
                            -two * z * (one + y)};
    const SymmetricTensor<Scalar> h{two - two * y, -Scalar(12) * y, -two - two * y,
                                    -two * x,      -two * z,        Scalar(0)};
    const SymmetricTensor<Scalar> adjugate{h.yy * h.zz - h.yz * h.yz, h.xx * h.zz - h.xz * h.xz,
                                           h.xx * h.yy - h.xy * h.xy, h.xz * h.yz - h.xy * h.zz,
                                           h.xy * h.xz - h.xx * h.yz, h.xy * h.yz - h.xz * h.yy};
    const Scalar gg = dot(g, g), size = sqrt(gg);
    const Scalar mean = (gg * trace(h) - dot(g, h * g)) / (two * gg * size);
    const Scalar gauss = dot(g, adjugate * g) / (gg * gg);
    EXPECT_LT(static_cast<double>(Scalar(abs(k->mean() - mean))), tolerance);
    EXPECT_LT(static_cast<double>(Scalar(abs(k->gauss() - gauss))), tolerance);
    EXPECT_NEAR(static_cast<double>(Scalar(dot(k->normal, g) / size)), 1, 1e-15);
  }
}

TEST(LevelCurvature, OfANeutralSurfaceIsThatOfItsCubic) {
  expect_implicit_curvature<double>(1e-11);
  expect_implicit_curvature<Real50>(1e-42);
}

RC_GTEST_PROP(LevelCurvature, InDoublesIsThatOfFiftyDigits, ()) {
  const Drawn d = drawn();
  const auto k = cell_of<double>(d.tensors).at(d.point);
  const auto exact = cell_of<Real50>(d.tensors).at(to<Real50>(d.point));
  RC_ASSERT(k.has_value() && exact.has_value());
  const double size = std::abs(static_cast<double>(exact->principal[0])) +
                      std::abs(static_cast<double>(exact->principal[1]));
  for (std::size_t i = 0; i < 2; ++i)
    RC_ASSERT(std::abs(k->principal[i] - static_cast<double>(exact->principal[i])) <
              1e-8 * (1 + size) * (1 + size));
}

// The curvature tensor times a tangent vector is how the normal changes along it.
RC_GTEST_PROP(LevelCurvature, IsTheDerivativeOfTheNormal, ()) {
  const Drawn d = drawn();
  const auto cell = cell_of<Real50>(d.tensors);
  const auto x = to<Real50>(d.point);
  const auto k = cell.at(x);
  RC_ASSERT(k.has_value());
  const Real50 h("1e-15");
  for (const auto& u : k->directions) {
    const auto forth = cell.at(x + h * u), back = cell.at(x - h * u);
    const Vector3<Real50> change =
        Real50(1 / (2 * h)) * (forth->normal - back->normal) - k->tensor * u;
    const Real50 scale = 1 + abs(k->principal[0]) + abs(k->principal[1]);
    // The level bends away from the straight line: the normal itself changes by h^2 only.
    RC_ASSERT(sqrt(dot(change, change)) < Real50("1e-12") * scale * scale * scale);
  }
}

RC_GTEST_PROP(LevelCurvature, ChangesSignWithTheField, ()) {
  const Drawn d = drawn();
  TetTensors opposite;
  for (std::size_t i = 0; i < 4; ++i) opposite[i] = -1.0 * d.tensors[i];
  const auto k = cell_of<double>(d.tensors).at(d.point), o = cell_of<double>(opposite).at(d.point);
  RC_ASSERT(k->principal[0] == -o->principal[1] && k->principal[1] == -o->principal[0]);
  RC_ASSERT(k->normal == -o->normal);
}

TetMesh ring_mesh(int n) {
  TetMesh mesh = cube_mesh(n);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    auto& p = mesh.points[i];
    p = (3.0 / n) * p - Vector3<double>{1.53, 1.47, 1.5};
    mesh.tensors[i] = kRing.at(p);
  }
  return mesh;
}

SurfaceMesh ring_surface(const TetMesh& mesh) {
  return extract_mode_surface<double>(mesh, ModeValue()).surface;
}

TEST(SurfaceCurvature, OfAnExtractedCylinderIsThatOfItsCircle) {
  const TetMesh mesh = ring_mesh(3);
  const SurfaceMesh surface = ring_surface(mesh);
  const SurfaceCurvature curvature = surface_curvature(surface, mesh);
  ASSERT_EQ(curvature.vertices.size(), surface.points.size());
  ASSERT_GT(surface.points.size(), 50u);
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    ASSERT_TRUE(curvature.vertices[v]);
    EXPECT_NEAR(curvature.vertices[v]->principal[0], 1, 1e-9);
    EXPECT_NEAR(curvature.vertices[v]->principal[1], 0, 1e-9);
    EXPECT_LT(curvature.normal_jump[v], 1e-9);  // one linear field in all tetrahedra
  }
  EXPECT_TRUE(curvature.umbilics.empty());
}

// Where tetrahedra have different fields the surface has an edge, and says how sharp it is.
TEST(SurfaceCurvature, TellsWhereTheSurfaceIsNotSmooth) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 4);
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse("1/5")).surface;
  const SurfaceCurvature curvature = surface_curvature(surface, mesh);
  double inside = 0, between = 0;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    double& largest = surface.carrier[v] == Carrier::tet ? inside : between;
    largest = std::max(largest, curvature.normal_jump[v]);
  }
  EXPECT_LT(inside, 1e-9);
  EXPECT_GT(between, 1e-3);
}

// The curvature has no unit of the tensors in it.
TEST(SurfaceCurvature, IsTheSameInAnyUnits) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 4);
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse("1/5")).surface;
  const SurfaceCurvature expected = surface_curvature(surface, mesh);
  const auto recovered = recovered_curvature(surface, mesh);
  std::size_t compared = 0;
  for (const int exponent : {-960, -200, 200, 1020}) {
    TetMesh scaled = mesh;
    for (auto& tensor : scaled.tensors) tensor = std::ldexp(1.0, exponent) * tensor;
    const SurfaceCurvature found = surface_curvature(surface, scaled);
    const auto found_recovered = recovered_curvature(surface, scaled);
    EXPECT_EQ(found.normal_jump, expected.normal_jump) << exponent;
    for (std::size_t v = 0; v < surface.points.size(); ++v) {
      ASSERT_EQ(found.vertices[v].has_value(), expected.vertices[v].has_value()) << exponent;
      ASSERT_EQ(found_recovered[v].has_value(), recovered[v].has_value()) << exponent;
      if (!expected.vertices[v] || !recovered[v]) continue;
      EXPECT_EQ(found.vertices[v]->principal, expected.vertices[v]->principal) << exponent;
      EXPECT_EQ(found_recovered[v]->principal, recovered[v]->principal) << exponent;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100u);
}

#if TENSORTOPO_HAS_JETS
// Cubic jets: the error of the curvature is of second order in the vertices' distance.
TEST(JetCurvature, ConvergesToThatOfTheField) {
  std::array<double, 2> errors{};
  for (std::size_t i = 0; i < 2; ++i) {
    const TetMesh mesh = ring_mesh(i == 0 ? 6 : 12);
    const SurfaceMesh surface = ring_surface(mesh);
    const auto fitted = jet_curvature(surface);
    std::vector<double> differences;
    for (const auto& k : fitted)
      if (k) differences.push_back(std::hypot(k->principal[0] - 1, k->principal[1]));
    ASSERT_GT(differences.size(), surface.points.size() / 2);
    std::sort(differences.begin(), differences.end());
    errors[i] = differences[differences.size() / 2];
  }
  EXPECT_LT(errors[0], 0.1);
  EXPECT_LT(errors[1], errors[0] / 3);
}
#endif

// A flat grid whose corners carry tensors of deviator (p, q) around a zero off the grid's lines.
SurfaceMesh flat_grid(bool turned_over) {
  SurfaceMesh grid;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) grid.points.push_back({x - 1.7, y - 2.2, 0.5});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const int a = 5 * y + x;
      grid.triangles.push_back({a, a + 1, a + 6});
      grid.triangles.push_back({a, a + 6, a + 5});
    }
  if (turned_over)
    for (auto& t : grid.triangles) std::swap(t[1], t[2]);
  return grid;
}

TEST(Umbilics, HaveTheIndexOfTheDirectionsAround) {
  for (const bool turned_over : {false, true})
    for (const int side : {1, -1}) {
      const SurfaceMesh grid = flat_grid(turned_over);
      std::vector<std::optional<LevelCurvature<double>>> corners;
      for (const auto& t : grid.triangles)
        for (const auto v : t) {
          const auto& p = grid.points[static_cast<std::size_t>(v)];
          // Half an angle's turn around a wedge, the reverse around a trisector.
          const SymmetricTensor<double> tensor{2 + p.x, 2 - p.x, 0, side * p.y, 0, 0};
          corners.push_back(curvature_of<double>({0, 0, turned_over ? -1.0 : 1.0}, tensor));
        }
      const auto umbilics = umbilics_of(grid, corners);
      ASSERT_EQ(umbilics.size(), 1u);
      EXPECT_EQ(umbilics[0].twice_index, side);
      EXPECT_NEAR(umbilics[0].point.x, 0, 1e-12);
      EXPECT_NEAR(umbilics[0].point.y, 0, 1e-12);
      EXPECT_NEAR(umbilics[0].curvature, 2, 1e-12);
    }
}

}  // namespace
}  // namespace tensortopo::test
