// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "extract/cases/curve_checks.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/compared.hpp"
#include "support/generators.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/manifold/field_lift.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

std::string obstacles(const CurveExtraction& extraction) {
  std::string names;
  for (const auto& cell : extraction.unresolved) names += std::string(name_of(cell.obstacle)) + ' ';
  return names;
}

TEST(DegenerateCurves, OfIndependentTensorsAreFlawless) {
  const std::uint64_t seed = 20250101;
  SCOPED_TRACE(announce(seed));
  std::size_t lines = 0, closed = 0;
  for (int trial = 0; trial < trials(6); ++trial) {
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    for (const Degeneracy kind : kKinds) {
      const auto extraction = extract_degenerate_curves(mesh, kind);
      EXPECT_EQ(obstacles(extraction), "");
      EXPECT_EQ(flaws(extraction, mesh, mode_of(kind)), "") << "trial " << trial;
      lines += extraction.curves.lines.size();
      closed += curve_invariants(extraction.curves).closed_components;
    }
  }
  std::cout << lines << " lines, " << closed << " closed components\n";
  EXPECT_GT(lines, 100u);
}

TEST(DegenerateCurves, OfSmoothFieldsAreFlawless) {
  const std::uint64_t seed = 20250102;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(4); ++trial) {
    TetMesh mesh = cube_mesh(5);
    fill_with_smooth_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    for (const Degeneracy kind : kKinds) {
      const auto extraction = extract_degenerate_curves(mesh, kind);
      EXPECT_EQ(obstacles(extraction), "");
      EXPECT_EQ(flaws(extraction, mesh, mode_of(kind)), "") << "trial " << trial;
    }
  }
}

/// Runs along the conic of a tetrahedron on which all weights have one sign, as far as equidistant
/// angles see them: of linear and of planar points.
std::array<std::size_t, 2> sampled_pieces(const TetTensors& tensors, int samples) {
  TetrahedronField<double> field;
  for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensors[i]);
  const auto n = characteristic_tensor(field);
  const FieldLift<double> lift(field);
  const double x = std::sqrt(-n->eigenvalues[2] / n->eigenvalues[0]);
  const double y = std::sqrt(-n->eigenvalues[2] / n->eigenvalues[1]);
  std::array<std::size_t, 2> runs{};
  const auto sign_at = [&](int k) {
    const double phi = 2 * std::acos(-1.0) * k / samples;
    const auto e = x * std::cos(phi) * n->eigenvectors[0] + y * std::sin(phi) * n->eigenvectors[1] +
                   n->eigenvectors[2];
    const auto w = lift.weights(
        SymmetricTensor<double>{e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.y * e.z, e.x * e.z});
    if (std::all_of(w.begin(), w.end(), [](double b) { return b > 0; })) return 1;
    return std::all_of(w.begin(), w.end(), [](double b) { return b < 0; }) ? -1 : 0;
  };
  for (int k = 0, last = sign_at(-1); k < samples; ++k) {
    const int sign = sign_at(k);
    if (sign != 0 && sign != last) ++runs[sign > 0 ? 0 : 1];
    last = sign;
  }
  return runs;
}

// The curve's own parameterisation, sampled densely, sees no more pieces, and seldom fewer.
TEST(DegenerateCurves, InATetrahedronAreThePiecesThatDenseSamplesSee) {
  const std::uint64_t seed = 20250103;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::size_t missed = 0, pieces = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    const auto sampled = sampled_pieces(tensors, 4000);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto extraction = extract_degenerate_curves(mesh, kKinds[k]);
      ASSERT_EQ(obstacles(extraction), "");
      const std::size_t lines = extraction.curves.lines.size();
      EXPECT_LE(sampled[k], lines) << exact_text(tensors);
      pieces += lines;
      missed += lines - std::min(lines, sampled[k]);
    }
  }
  std::cout << pieces << " pieces, samples missed " << missed << '\n';
  EXPECT_GT(pieces, 50u);
  EXPECT_LE(50 * missed, pieces);
}

RC_GTEST_PROP(DegenerateCurves, OfSmallIntegersAreFlawless, ()) {
  const TetSample sample = *small_integer_tet(*rc::gen::inRange(1, 10));
  const TetMesh mesh = reference_tet_mesh(sample.tensors);
  for (const Degeneracy kind : kKinds) {
    const auto extraction = extract_degenerate_curves(mesh, kind);
    RC_ASSERT(flaws(extraction, mesh, mode_of(kind), CurveEnds::free) == "");
    for (const auto& cell : extraction.unresolved)
      RC_ASSERT(cell.obstacle != CurveObstacle::points_not_told_apart);
    RC_CLASSIFY(!extraction.unresolved.empty(), "more than curves");
    RC_CLASSIFY(!extraction.curves.lines.empty(), "crossed");
  }
}

/// The faces and tetrahedra through which the lines go, and how often.
std::map<std::array<Index, 4>, int> places(const CurveMesh& curves) {
  std::map<std::array<Index, 4>, int> result;
  for (const auto& line : curves.lines)
    for (const Index v : {line.front(), line.back()})
      ++result[curves.carrier_vertices[static_cast<std::size_t>(v)]];
  return result;
}

std::array<std::size_t, 4> shape(const CurveMesh& curves) {
  const auto known = curve_invariants(curves);
  return {curves.lines.size(), known.vertices, known.components, known.closed_components};
}

TEST(DegenerateCurves, ChangeKindAndNothingElseWhenAllSignsChange) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20250104);
  TetMesh opposite = mesh;
  for (auto& t : opposite.tensors) t = -1.0 * t;
  for (const Degeneracy kind : kKinds) {
    const Degeneracy other = kind == Degeneracy::linear ? Degeneracy::planar : Degeneracy::linear;
    const auto one = extract_degenerate_curves(mesh, kind).curves;
    const auto two = extract_degenerate_curves(opposite, other).curves;
    EXPECT_EQ(places(one), places(two));
    EXPECT_EQ(shape(one), shape(two));
  }
}

TEST(DegenerateCurves, AreTheSameBitsWhenScaledByPowersOfTwo) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20250105);
  // Few enough bits for the smallest numbers to be exact.
  for (auto& t : mesh.tensors) t = rounded(t, 16);
  for (const int exponent : {-900, 900}) {
    TetMesh scaled = mesh;
    for (auto& t : scaled.tensors) t = std::ldexp(1.0, exponent) * t;
    for (const Degeneracy kind : kKinds) {
      const auto one = extract_degenerate_curves(mesh, kind).curves;
      const auto two = extract_degenerate_curves(scaled, kind).curves;
      EXPECT_EQ(one.points, two.points);
      EXPECT_EQ(one.lines, two.lines);
      EXPECT_EQ(one.separation, two.separation);
    }
  }
}

TEST(DegenerateCurves, KeepTheirShapeWhenEachTensorHasItsOwnPowerOfTwo) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20250106);
  for (auto& t : mesh.tensors) t = rounded(t, 16);
  TetMesh scaled = mesh;
  Random random(3);
  for (auto& t : scaled.tensors) t = std::ldexp(1.0, random.integer(-200, 200)) * t;
  for (const Degeneracy kind : kKinds)
    EXPECT_EQ(places(extract_degenerate_curves(mesh, kind).curves),
              places(extract_degenerate_curves(scaled, kind).curves));
}

TEST(DegenerateCurves, KeepTheirShapeWhenVerticesAreRenumbered) {
  TetMesh mesh = cube_mesh(3);
  fill_with_normal_tensors(mesh, 20250107);
  const std::size_t n = mesh.points.size();
  TetMesh turned = mesh;
  for (std::size_t v = 0; v < n; ++v) {
    turned.points[n - 1 - v] = mesh.points[v];
    turned.tensors[n - 1 - v] = mesh.tensors[v];
  }
  for (auto& tet : turned.tets)
    for (Index& v : tet) v = static_cast<Index>(n) - 1 - v;
  for (const Degeneracy kind : kKinds) {
    const auto one = extract_degenerate_curves(mesh, kind).curves;
    const auto two = extract_degenerate_curves(turned, kind).curves;
    EXPECT_EQ(shape(one), shape(two));
    EXPECT_NEAR(curve_invariants(one).length, curve_invariants(two).length, 1e-9);
  }
}

TEST(DegenerateCurves, AreTheSameForAnyNumberOfThreads) {
  TetMesh mesh = cube_mesh(4);
  fill_with_normal_tensors(mesh, 20250108);
  for (const Degeneracy kind : kKinds) {
    std::vector<CurveMesh> results;
    for (const std::size_t threads : {1u, 2u, 4u}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      results.push_back(extract_degenerate_curves(mesh, kind).curves);
    }
    for (const CurveMesh& other : results) {
      EXPECT_EQ(other.points, results[0].points);
      EXPECT_EQ(other.lines, results[0].lines);
      EXPECT_EQ(other.residual, results[0].residual);
      EXPECT_EQ(other.component, results[0].component);
    }
  }
}

TEST(DegenerateCurves, TurnByLessThanTheResolutionBetweenSamples) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20250109);
  for (const double resolution : {2.0, 10.0, 50.0}) {
    ExtractOptions options;
    options.sampling.resolution = resolution;
    const auto curves = extract_degenerate_curves(mesh, Degeneracy::linear, options).curves;
    for (const auto& line : curves.lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto& u = curves.dominant_eigenvector[static_cast<std::size_t>(line[i])];
        const auto& v = curves.dominant_eigenvector[static_cast<std::size_t>(line[i + 1])];
        EXPECT_LE(std::acos(std::min(1.0, std::abs(dot(u, v)))), 1.000001 / resolution);
      }
  }
}

TEST(DegenerateCurves, OfWitnessFieldsAreFlawless) {
  for (const auto& witness : field_witnesses())
    for (const auto& tet : witness.cases)
      for (const Degeneracy kind : kKinds) {
        const TetMesh mesh = single_tet_mesh(tet.points, witness.field.at(tet.points));
        const auto extraction = extract_degenerate_curves(mesh, kind);
        EXPECT_EQ(flaws(extraction, mesh, mode_of(kind)), "") << witness.name;
        if (!extraction.unresolved.empty())
          std::cout << witness.name << ": " << obstacles(extraction) << '\n';
      }
}

// The deviator across the z axis is (x, y), which turns once around the axis: a wedge; with (x, -y)
// a trisector. Small parts besides make the rank four and the characteristic tensor general.
TEST(DegenerateCurves, TellWedgesFromTrisectors) {
  const LinearField general{{1, 1, -2, 0, 0, 0},
                            {1, -1, 0, 0, 1.0 / 8, 0},
                            {0, 0, 0, 1, 0, 0},
                            {1, 1, -2, 0, 0, 1.0 / 8}};
  const std::array<Vector3<double>, 4> points{
      {{0.5, 0.75, -0.5}, {-1, 0.25, -0.5}, {0.25, -1, -0.5}, {0.0625, 0.125, 0.5}}};
  const TetMesh mesh = single_tet_mesh(points, general.at(points));
  const auto extraction = extract_degenerate_curves(mesh, Degeneracy::planar);
  EXPECT_EQ(flaws(extraction, mesh, -1), "");
  for (const double s : extraction.curves.separation) EXPECT_GT(s, 0);
  EXPECT_FALSE(extraction.curves.lines.empty());
  LinearField mirrored = general;
  mirrored.dy = -1.0 * mirrored.dy;
  const TetMesh other = single_tet_mesh(points, mirrored.at(points));
  const auto trisectors = extract_degenerate_curves(other, Degeneracy::planar).curves;
  EXPECT_FALSE(trisectors.lines.empty());
  for (const double s : trisectors.separation) EXPECT_LT(s, 0);
}

TEST(DegenerateCurves, OfNothingAreNothing) {
  const auto extraction = extract_degenerate_curves(TetMesh{}, Degeneracy::linear);
  EXPECT_TRUE(extraction.curves.points.empty());
  EXPECT_TRUE(extraction.unresolved.empty());
}

TEST(Separation, IsFiniteWhereTensorsDifferByManyOrdersOfMagnitude) {
  const std::array<SymmetricTensor<double>, 4> tensors{{{1.3, -1.3, 6.4, 1, -5.4, 3.6},
                                                        {1.3, 0.95, -0.7, -1.27, -0.62, 0.04},
                                                        {-2.33, -0.22, -1.25, -0.73, -0.54, -0.32},
                                                        {0.41, 1.04, -0.13, 1.37, -0.67, 0.35}}};
  Compared compared("vertices", 8);
  for (const double scale : {1e-150, 1e-161, 1e-200}) {
    auto scaled = tensors;
    scaled[0] = scale * scaled[0];
    const std::array<Vector3<double>, 4> points{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const auto curves =
        extract_degenerate_curves(single_tet_mesh(points, scaled), Degeneracy::linear).curves;
    for (const double s : curves.separation) {
      EXPECT_TRUE(std::isfinite(s)) << s;
      ++compared;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
