// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "analyze/curvature/ridges.hpp"
#include "analyze/curvature/surface_curvature.hpp"
#include "analysis/analyze/level_cells.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

// Along a principal direction the curvature's derivative is the extremality: to 50 digits by a
// difference between two points. A straight line leaves the level, but by h^2 on both sides alike.
RC_GTEST_PROP(Extremality, IsTheDerivativeOfTheCurvatureAlongItsDirection, ()) {
  const Drawn d = drawn();
  const auto cell = cell_of<Real50>(d.tensors);
  const auto x = to<Real50>(d.point);
  const auto e = cell.extremality(x);
  RC_ASSERT(e.has_value());
  const auto& k = e->curvature;
  const Real50 spread = k.principal[0] - k.principal[1], h("1e-15");
  const Real50 scale = 1 + abs(k.principal[0]) + abs(k.principal[1]);
  RC_PRE(spread > scale / 1000);
  for (const std::size_t i : {0u, 1u}) {
    const auto& t = k.directions[i];
    const auto forth = cell.extremality(x + h * t);
    const auto back = cell.extremality(x - h * t);
    const Real50 slope = (forth->curvature.principal[i] - back->curvature.principal[i]) / (2 * h);
    RC_ASSERT(abs(slope - e->extremality[i]) < Real50("1e-12") * e->largest * scale);
    RC_ASSERT(abs(e->extremality[i]) <= e->largest);
  }
}

RC_GTEST_PROP(Extremality, InDoublesIsThatOfFiftyDigits, ()) {
  const Drawn d = drawn();
  const auto e = cell_of<double>(d.tensors).extremality(d.point);
  const auto exact = cell_of<Real50>(d.tensors).extremality(to<Real50>(d.point));
  RC_ASSERT(e.has_value() && exact.has_value());
  const auto& k = e->curvature.principal;
  RC_PRE(k[0] - k[1] > 1e-3 * (std::abs(k[0]) + std::abs(k[1])));
  for (const std::size_t i : {0u, 1u}) {
    // Either may have the opposite direction.
    const Real50 same = dot(to<Real50>(e->curvature.directions[i]), exact->curvature.directions[i]);
    const double expected = (same < 0 ? -1 : 1) * static_cast<double>(exact->extremality[i]);
    RC_ASSERT(std::abs(e->extremality[i] - expected) < 1e-8 * e->largest);
  }
}

// The larger curvature of a field is the smaller one of its opposite, with the sign changed.
RC_GTEST_PROP(Extremality, ChangesPlacesWithTheSignOfTheField, ()) {
  const Drawn d = drawn();
  TetTensors opposite;
  for (std::size_t i = 0; i < 4; ++i) opposite[i] = -1.0 * d.tensors[i];
  const auto e = cell_of<double>(d.tensors).extremality(d.point),
             o = cell_of<double>(opposite).extremality(d.point);
  for (const std::size_t i : {0u, 1u})
    RC_ASSERT(std::abs(std::abs(e->extremality[i]) - std::abs(o->extremality[1 - i])) <=
              1e-12 * e->largest);
}

// Eigenvalues 1 + r, 1 - r and -2 with r^2 = x^2 + 4 y^2: levels of the mode are elliptic
// cylinders. Their normals point outward for r < 3.
const LinearField kEllipticRing{{1, 1, -2, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, {0, 0, 0, 2, 0, 0}, {}};

// An ellipse (a cos s, b sin s) has the curvature a b w^-3, w^2 = a^2 sin^2 s + b^2 cos^2 s; its
// derivative by arc length is -3 a b (a^2 - b^2) sin s cos s / w^6.
TEST(Extremality, OfAnEllipticCylinderIsThatOfItsEllipse) {
  const double a = 1.5, b = 0.75;
  const auto cell = cell_of<double>(kEllipticRing);
  for (const double s : {0.0, 0.3, 0.7, 1.2, std::numbers::pi / 2, 2.5, 4.0}) {
    const double c = std::cos(s), n = std::sin(s), w = std::hypot(a * n, b * c);
    const auto e = cell.extremality({a * c, b * n, 0.2});
    ASSERT_TRUE(e);
    EXPECT_NEAR(e->curvature.principal[0], a * b / (w * w * w), 1e-12);
    const double along = dot(e->curvature.directions[0], {-a * n / w, b * c / w, 0});  // 1 or -1
    EXPECT_NEAR(std::abs(along), 1, 1e-12);
    EXPECT_NEAR(e->extremality[0], -3 * along * a * b * (a * a - b * b) * n * c / std::pow(w, 6),
                1e-11);
    EXPECT_TRUE(e->is_flat(1));
    EXPECT_EQ(e->is_flat(0), s == 0 || s == std::numbers::pi / 2);
  }
}

TetMesh mesh_of(const LinearField& field, int n) {
  TetMesh mesh = cube_mesh(n);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    auto& p = mesh.points[i];
    p = (3.0 / n) * p - Vector3<double>{1.53, 1.47, 1.5};
    mesh.tensors[i] = field.at(p);
  }
  return mesh;
}

// Root mean square, over the points of lines, of a distance.
template <class Distance>
double typical(const RidgeLines& ridges, RidgeKind kind, const Distance& distance) {
  double sum = 0, count = 0;
  for (const auto& line : ridges.lines)
    if (line.kind == kind)
      for (const auto v : line.points) {
        const double d = distance(ridges.points[static_cast<std::size_t>(v)]);
        sum += d * d;
        ++count;
      }
  return std::sqrt(sum / count);
}

// The neutral surface is the cylinder x^2 + 4 y^2 = 1: its ridges are the two lines x = +-1, y = 0,
// from one end of the block to the other; along the other lines it is straight.
TEST(Ridges, OfAnExtractedEllipticCylinderAreTheLinesWhereItBendsMost) {
  std::array<double, 2> errors{};
  for (const std::size_t i : {0u, 1u}) {
    const TetMesh mesh = mesh_of(kEllipticRing, 6);
    ExtractOptions options;
    options.sampling.resolution = i == 0 ? 4 : 8;
    const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue(), options).surface;
    const RidgeLines ridges = surface_ridges(surface, mesh);
    const auto& [ridge, valley] = ridges.sums;
    EXPECT_EQ(ridge.lines, 2u);
    EXPECT_EQ(ridge.closed, 0u);
    EXPECT_EQ(valley.lines, 0u);
    EXPECT_EQ(valley.flat_triangles, surface.triangles.size());
    EXPECT_EQ(ridge.ends[static_cast<std::size_t>(RidgeEnd::boundary)], 4u);
    EXPECT_NEAR(ridge.length, 6, 0.1);
    EXPECT_NEAR(ridge.crest_length, ridge.length, 1e-12);
    // One linear field everywhere: both sides of a face see the same point.
    EXPECT_GT(ridge.bridges, 0u);
    EXPECT_LT(ridge.bridge_length, 1e-9);
    errors[i] = typical(ridges, RidgeKind::ridge, [](const Vector3<double>& p) {
      return std::hypot(std::abs(p.x) - 1, p.y);
    });
    for (const auto& line : ridges.lines)
      for (const auto v : line.points)
        EXPECT_NEAR(ridges.curvature[static_cast<std::size_t>(v)], 4, 60 * errors[i]);
  }
  EXPECT_LT(errors[0], 0.03);
  EXPECT_LT(errors[1], errors[0] / 2.5);
}

// With the opposite field the normals point inward, and ridges are valleys.
TEST(Ridges, AreTheValleysOfTheOppositeField) {
  TetMesh mesh = mesh_of(kEllipticRing, 6);
  const ModeValue mode = ModeValue::parse("1/5");
  const RidgeLines ridges = surface_ridges(extract_mode_surface<double>(mesh, mode).surface, mesh);
  for (auto& t : mesh.tensors) t = -1.0 * t;
  const RidgeLines valleys =
      surface_ridges(extract_mode_surface<double>(mesh, mode.opposite()).surface, mesh);
  ASSERT_EQ(ridges.sums[0].lines, 2u);
  EXPECT_EQ(valleys.sums[0].lines, 0u);
  EXPECT_EQ(valleys.sums[1].lines, 2u);
  EXPECT_NEAR(valleys.sums[1].length, ridges.sums[0].length, 0.05);
}

// An ellipsoid with half axes 3, 2, 1, from a subdivided octahedron, with the derivatives of
// x^2 / 9 + y^2 / 4 + z^2 - 1. `turn` keeps the mesh's edges off the planes of symmetry.
struct Ellipsoid {
  SurfaceMesh surface;
  std::vector<std::optional<LevelExtremality<double>>> corners;
};

constexpr std::array<double, 3> kAxes{3, 2, 1};

Ellipsoid ellipsoid(int n) {
  const Vector3<double> a = unit(Vector3<double>{0.9, 0.31, -0.17}),
                        b = unit(cross(a, Vector3<double>{0.2, -0.3, 0.9})), c = cross(a, b);
  Ellipsoid result;
  SurfaceMesh& surface = result.surface;
  std::map<std::array<int, 3>, SurfaceMesh::Index> known;
  const auto vertex = [&](const std::array<int, 3>& lattice) {
    const auto [found, is_new] =
        known.emplace(lattice, static_cast<SurfaceMesh::Index>(surface.points.size()));
    if (is_new) {
      const auto v = unit(double(lattice[0]) * a + double(lattice[1]) * b + double(lattice[2]) * c);
      surface.points.push_back({kAxes[0] * v.x, kAxes[1] * v.y, kAxes[2] * v.z});
    }
    return found->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const auto at = [&](int i, int j) {
      return vertex(
          {octant & 1 ? -i : i, octant & 2 ? -j : j, octant & 4 ? -(n - i - j) : n - i - j});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        surface.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 2 <= n)
          surface.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  surface.tet.assign(surface.triangles.size(), 0);
  for (const auto& t : surface.triangles)
    for (const auto v : t) {
      const auto& p = surface.points[static_cast<std::size_t>(v)];
      const SymmetricTensor<double> hessian{2 / 9.0, 2 / 4.0, 2, 0, 0, 0};
      const Vector3<double> gradient = hessian * p;
      const auto curvature = level_curvature(gradient, hessian);
      LevelExtremality<double> corner{*curvature, {}, 1};
      for (const std::size_t i : {0u, 1u})
        corner.extremality[i] =
            extremality(*curvature, i, std::sqrt(dot(gradient, gradient)), hessian, 0.0);
      result.corners.emplace_back(corner);
    }
  return result;
}

double perimeter(double a, double b) {
  double sum = 0;
  constexpr int kSteps = 1000;  // the trapezoidal rule: exact to rounding on a period
  for (int i = 0; i < kSteps; ++i) {
    const double s = 2 * std::numbers::pi * i / kSteps;
    sum += std::hypot(a * std::sin(s), b * std::cos(s)) * 2 * std::numbers::pi / kSteps;
  }
  return sum;
}

// The ridge of an ellipsoid is its largest ellipse, its valley the one across the longest axis. The
// third one is no line of either: the curvature across it is smallest where it is the larger one,
// and largest where it is the smaller one. It holds the four umbilics.
TEST(Ridges, OfAnEllipsoidAreTwoOfItsEllipses) {
  std::array<double, 2> errors{};
  for (const std::size_t i : {0u, 1u}) {
    const Ellipsoid e = ellipsoid(i == 0 ? 40 : 80);
    const RidgeLines ridges = ridges_of(e.surface, e.corners);
    const auto& [ridge, valley] = ridges.sums;
    EXPECT_EQ(ridge.lines, 1u);
    EXPECT_EQ(ridge.closed, 1u);
    EXPECT_EQ(valley.lines, 1u);
    EXPECT_EQ(valley.closed, 1u);
    EXPECT_EQ(ridges.umbilic_triangles, 4u);
    errors[i] =
        std::max(typical(ridges, RidgeKind::ridge, [](const auto& p) { return std::abs(p.z); }),
                 typical(ridges, RidgeKind::valley, [](const auto& p) { return std::abs(p.x); }));
    EXPECT_NEAR(ridge.length, perimeter(3, 2), 0.02);
    EXPECT_NEAR(valley.length, perimeter(2, 1), 0.02);
    EXPECT_NEAR(ridge.crest_length, ridge.length, 1e-12);
    EXPECT_EQ(valley.crest_length, 0);
  }
  EXPECT_LT(errors[0], 0.02);
  EXPECT_LT(errors[1], errors[0] / 3);
}

// All umbilics of an ellipsoid are lemons, where its ellipse through the longest and the shortest
// axis is met by the circular sections' tangent planes.
TEST(Umbilics, OfAnEllipsoidAreFoundByItsCurvaturesAtVertices) {
  const Ellipsoid e = ellipsoid(40);
  std::vector<std::optional<LevelCurvature<double>>> vertices(e.surface.points.size());
  for (std::size_t i = 0; i < e.corners.size(); ++i)
    vertices[static_cast<std::size_t>(e.surface.triangles[i / 3][i % 3])] = e.corners[i]->curvature;
  const auto umbilics = umbilics_of(e.surface, at_corners(e.surface, vertices));
  ASSERT_EQ(umbilics.size(), 4u);
  for (const Umbilic& umbilic : umbilics) {
    EXPECT_EQ(umbilic.twice_index, 1);
    EXPECT_NEAR(std::abs(umbilic.point.x), 3 * std::sqrt(5.0 / 8), 0.02);
    EXPECT_NEAR(umbilic.point.y, 0, 0.02);
    EXPECT_NEAR(std::abs(umbilic.point.z), std::sqrt(3.0 / 8), 0.02);
    EXPECT_NEAR(umbilic.curvature, 3.0 / 8, 0.02);
  }
}

// The same from curvatures alone, as they are known at vertices.
TEST(Ridges, OfAnEllipsoidAreFoundByItsCurvaturesAtVertices) {
  const Ellipsoid e = ellipsoid(40);
  std::vector<std::optional<LevelCurvature<double>>> vertices(e.surface.points.size());
  for (std::size_t i = 0; i < e.corners.size(); ++i)
    vertices[static_cast<std::size_t>(e.surface.triangles[i / 3][i % 3])] = e.corners[i]->curvature;
  const RidgeLines ridges = ridges_of(e.surface, vertices);
  // Next to umbilics, where curvatures are not smooth, there may be more, and short.
  const auto longest = [&](RidgeKind kind) {
    const RidgeLines::Line* result = nullptr;
    for (const auto& line : ridges.lines)
      if (line.kind == kind && (result == nullptr || line.length > result->length)) result = &line;
    return *result;
  };
  const auto ridge = longest(RidgeKind::ridge), valley = longest(RidgeKind::valley);
  EXPECT_TRUE(ridge.is_closed());
  EXPECT_TRUE(valley.is_closed());
  EXPECT_NEAR(ridge.length, perimeter(3, 2), 0.1);
  EXPECT_NEAR(valley.length, perimeter(2, 1), 0.1);
  EXPECT_LT(ridges.sums[0].length + ridges.sums[1].length, ridge.length + valley.length + 0.5);
  for (const auto v : ridge.points)
    EXPECT_NEAR(ridges.points[static_cast<std::size_t>(v)].z, 0, 0.05);
  EXPECT_EQ(ridges.sums[0].bridges, 0u);
}

// Between tetrahedra of different fields the lines do not meet, and say so.
TEST(Ridges, OfAPiecewiseFieldTellHowTheyEnd) {
  TetMesh mesh = cube_mesh(3);
  fill_with_smooth_tensors(mesh, 4);
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse("1/5")).surface;
  const RidgeLines ridges = surface_ridges(surface, mesh);
  ASSERT_GT(ridges.lines.size(), 10u);
  std::size_t ends = 0, open = 0;
  for (const auto& sum : ridges.sums) {
    for (const std::size_t n : sum.ends) ends += n;
    open += 2 * (sum.lines - sum.closed);
    EXPECT_GT(sum.ends[static_cast<std::size_t>(RidgeEnd::face)], 0u);
    EXPECT_GT(sum.bridge_length, 0);
  }
  EXPECT_EQ(ends, open);
  for (const auto& line : ridges.lines)
    for (const auto v : line.points) {
      const auto i = static_cast<std::size_t>(v);
      EXPECT_EQ(line.kind == RidgeKind::ridge, ridges.curvature[i] >= ridges.other_curvature[i]);
      EXPECT_GT(ridges.strength[i], 0);
    }
}

// What a filter keeps and what it leaves out are the whole; what it keeps it keeps as it was.
RC_GTEST_PROP(RidgeFilters, KeepStrongLinesWholeAndCountTheOthers, ()) {
  static const RidgeLines all = [] {
    TetMesh mesh = cube_mesh(3);
    fill_with_smooth_tensors(mesh, 4);
    const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse("1/5")).surface;
    return surface_ridges(surface, mesh);
  }();
  const auto any = [] { return *rc::gen::inRange(std::size_t{0}, all.lines.size()); };
  const RidgeFilter filter{all.lines[any()].strength, all.lines[any()].length / 4};
  const RidgeLines kept = filtered(all, filter);
  std::vector<const RidgeLines::Line*> passed;
  for (const auto& line : all.lines)
    if (line.strength >= filter.least_strength && line.length >= filter.least_length)
      passed.push_back(&line);
  RC_ASSERT(kept.lines.size() == passed.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const auto &line = kept.lines[i], &before = *passed[i];
    RC_ASSERT(line.points.size() == before.points.size());
    points += line.points.size() - line.is_closed();
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const auto v = static_cast<std::size_t>(line.points[k]),
                 w = static_cast<std::size_t>(before.points[k]);
      RC_ASSERT(kept.points[v] == all.points[w] && kept.strength[v] == all.strength[w]);
      RC_ASSERT(kept.strength[v] <= line.strongest);
    }
    RC_ASSERT(line.strength <= line.strongest * (1 + 1e-12));
  }
  RC_ASSERT(kept.points.size() == points);
  for (const std::size_t kind : {0u, 1u}) {
    const auto &sum = kept.sums[kind], &whole = all.sums[kind];
    RC_ASSERT(sum.lines + sum.left_out == whole.lines);
    RC_ASSERT(std::abs(sum.length + sum.left_out_length - whole.length) < 1e-9);
    std::size_t ends = 0;
    for (const std::size_t n : sum.ends) ends += n;
    RC_ASSERT(ends == 2 * (sum.lines - sum.closed));
  }
}

}  // namespace
}  // namespace tensortopo::test
