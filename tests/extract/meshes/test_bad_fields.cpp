// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "extract/cases/extract_case.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

TEST(BadModes, AreRefused) {
  const TetMesh mesh = reference_tet_mesh(Random(1).tet_tensors());
  for (const char* mode : {"1", "-1", "1.0"})
    EXPECT_THROW(extract(mesh, mode), std::invalid_argument) << mode;
  for (const char* mode : {"0", "0/7", "1e-9", "-0.999999", "143/343"})
    EXPECT_NO_THROW(extract(mesh, mode)) << mode;
}

TEST(BadFields, NoDeviatorAnywhereGivesNothing) {
  TetMesh mesh = cube_mesh(2);
  for (auto& t : mesh.tensors) t = {-3, -3, -3, 0, 0, 0};
  const Extraction extraction = extract(mesh, "1/2");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(extraction.statistics.tets_undefined, mesh.tets.size());
  EXPECT_EQ(extraction.statistics.zero_deviator_vertices, mesh.points.size());
  EXPECT_TRUE(extraction.surface.triangles.empty());
}

// A deviator too small for its square to be a double is one all the same.
TEST(BadFields, TinyDeviatorsAreDeviators) {
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 20241002);
  for (auto& t : mesh.tensors) t = rounded(t, 8);
  TetMesh tiny = mesh;
  for (auto& t : tiny.tensors) t = 0x1p-1060 * t;  // subnormal, without a bit lost
  const Extraction extraction = extract(tiny, "1/2"), unit = extract(mesh, "1/2");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(summary(extraction.surface), summary(unit.surface));
}

// Independent deviators that are dependent once xx - yy is rounded: the mode is -143/343 all along
// an edge, but for rounding.
TEST(BadFields, RoundingMayLowerTheRank) {
  const TetTensors tensors{
      {{0x1.dbffffffffffdp+6, -0x1.9600000000001p+8, 0x1.1fp+8, 0x1.f7ffffffffffdp+6,
        0x1.7a00000000001p+8, -0x1.f7fffffffffffp+7},
       {0x1.03p+8, 0x1.c000000000006p+4, -0x1.1fp+8, 0x1.c000000000021p+2, -0x1.f8p+5,
        0x1.18p+6},
       {0x1.dc00000000002p+6, -0x1.96p+8, 0x1.1fp+8, 0x1.f7ffffffffffep+6, 0x1.7a00000000001p+8,
        -0x1.f7fffffffffffp+7},
       {-0x1.1000000000002p+6, -0x1.22p+8, 0x1.66p+8, -0x1.a000000000006p+3,
        -0x1.0400000000002p+6, 0x1.8000000000056p+1}}};
  ASSERT_EQ(exact_rank(tensors), 4);
  const TetMesh mesh = reference_tet_mesh(tensors);
  const Extraction extraction = extract(mesh, "-143/343");
  EXPECT_EQ(flaws(extraction, mesh, {.residuals = false, .coincidences = false}), "");
}

// xx - yy overflows a double though both are doubles.
TEST(BadFields, DifferencesBeyondTheRangeOfDoublesAreFine) {
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 20241003);
  for (auto& t : mesh.tensors) t = rounded(t, 8);
  double largest = 0;
  for (const auto& t : mesh.tensors)
    largest = std::max({largest, std::abs(t.xx), std::abs(t.yy), std::abs(t.zz), std::abs(t.xy),
                        std::abs(t.yz), std::abs(t.xz)});
  TetMesh huge = mesh;
  const double factor = std::ldexp(1.0, 1023 - std::ilogb(largest));
  for (auto& t : huge.tensors) t = factor * t;
  const Extraction extraction = extract(huge, "1/2"), unit = extract(mesh, "1/2");
  EXPECT_EQ(unresolved_text(extraction), "");
  EXPECT_EQ(summary(extraction.surface), summary(unit.surface));
}

// Two vertices with deviators of the ratio -1: the deviator vanishes in the middle of the edge.
// Around such a vertex the level is, to doubles, a cone: its points round to the vertex, where the
// tensor is tiny beside those around, or to places where the huge one is all.
TEST(BadFields, AVertexOfAnotherMagnitudeLeavesEveryNumberFinite) {
  const TetMesh mesh = reference_tet_mesh(Random(20241122).tet_tensors());
  for (const int exponent : {-1060, 1000}) {
    TetMesh other = mesh;
    auto& t = other.tensors[2];
    for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = std::ldexp(*x, exponent);
    for (const char* mode : {"-1/2", "1/4"}) {
      const Extraction extraction = extract(other, mode);
      for (const double r : extraction.surface.residual) EXPECT_LE(std::abs(r), 2) << exponent;
      for (const auto* vectors :
           {&extraction.surface.normal, &extraction.surface.dominant_eigenvector})
        for (const auto& v : *vectors) EXPECT_NEAR(dot(v, v), 1, 1e-9) << exponent << mode;
    }
  }
}

TEST(BadFields, AZeroInsideAnEdgeIsNamedOrAvoided) {
  Random random(20241004);
  for (int trial = 0; trial < trials(10); ++trial) {
    TetTensors tensors = random.tet_tensors();
    tensors[1] = -1.0 * tensors[0];
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction = extract(mesh, "1/2");
    EXPECT_EQ(flaws(extraction, mesh, {.residuals = false}), "");
    for (const auto& cell : extraction.unresolved)
      EXPECT_EQ(cell.reason, UnresolvedReason::zero_deviator_inside);
  }
}

// The same tensor everywhere, in a mesh: nothing, and nothing unresolved, but on its own level.
TEST(BadFields, AConstantFieldHasNoSurface) {
  TetMesh mesh = cube_mesh(3);
  for (auto& t : mesh.tensors) t = {11, 2, -13, 0, 0, 0};
  for (const char* mode : kLevels) {
    const Extraction extraction = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(extraction), "");
    EXPECT_TRUE(extraction.surface.triangles.empty());
    EXPECT_EQ(extraction.statistics.tets_screened_out, mesh.tets.size());
  }
  const Extraction on = extract(mesh, "-143/343");
  EXPECT_EQ(on.statistics.vertices_on_level, mesh.points.size());
  EXPECT_EQ(on.unresolved.size(), mesh.tets.size());
}

// A vertex of the mesh exactly on the level, which no double equals.
TEST(BadFields, AVertexOnTheLevelIsCountedAndCountsAsBelow) {
  const std::uint64_t seed = 20241005;
  SCOPED_TRACE(announce(seed));
  for (int trial = 0; trial < trials(3); ++trial) {
    TetMesh mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    mesh.tensors[13] = {11, 2, -13, 0, 0, 0};
    const Extraction on = extract(mesh, "-143/343"),
                     above = extract(mesh, "-416909620991/1000000000000");  // 4e-13 higher
    EXPECT_EQ(on.statistics.vertices_on_level, 1u);
    EXPECT_EQ(above.statistics.vertices_on_level, 0u);
    EXPECT_EQ(unresolved_text(on), "");
    EXPECT_EQ(summary(on.surface), summary(above.surface)) << "trial " << trial;
    EXPECT_EQ(flaws(on, mesh, {.residuals = true, .coincidences = false}), "") << "trial " << trial;
  }
}

// Edges that carry the same tensor at both ends, up to a factor: constant mode along them.
TEST(BadFields, EqualTensorsAtTheEndsOfAnEdgeAreFine) {
  const std::uint64_t seed = 20241006;
  SCOPED_TRACE(announce(seed));
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, seed);
  for (std::size_t v = 0; v + 1 < mesh.tensors.size(); v += 3)
    mesh.tensors[v + 1] = (v % 2 ? 0.5 : 1.0) * mesh.tensors[v];
  for (const char* mode : kLevels) {
    const Extraction extraction = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(extraction), "") << mode;
    EXPECT_EQ(flaws(extraction, mesh), "") << mode;
  }
}

}  // namespace
}  // namespace tensortopo::test
