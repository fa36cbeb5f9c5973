// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "exact_transitions.hpp"
#include "extract/cases/curve_checks.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/curves/curve_vertex.hpp"
#include "support/compared.hpp"
#include "support/generators.hpp"
#include "tensortopo/extract/curve_arcs.hpp"

namespace tensortopo::test {
namespace {

/// Transitions inside tetrahedra, jumps, and lines not proved.
std::array<std::size_t, 3> counts(const TetMesh& mesh, Degeneracy kind) {
  const auto extraction = extract_degenerate_curves(mesh, kind);
  const auto all = curve_separation(CurveArcs(mesh, kind, extraction.curves));
  std::array<std::size_t, 3> result{0, all.jumps.size(), 0};
  for (const auto& line : all.lines) {
    result[0] += line.zeros.size();
    result[2] += line.obstacle.has_value();
  }
  return result;
}

// Zeros of another polynomial, in rationals, by another method.
TEST(CurveArcs, TransitionsAreThoseOfTangentsAcrossInRationals) {
  const std::uint64_t seed = 20261101;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  Compared fields("fields", 150), zeros("transitions", 50), several("several in one field", 10);
  std::size_t skipped = 0;
  for (int trial = 0; trial < trials(500, 250); ++trial) {
    const auto entry = [&](int bound) {
      return static_cast<double>(random.integer(-bound, bound));
    };
    TetTensors tensors;
    for (std::size_t i = 1; i < 4; ++i)
      tensors[i] = {entry(9), entry(9), entry(9), entry(9), entry(9), entry(9)};
    const Vector3<double> e{entry(4), entry(4), entry(4)};
    const double k = random.integer(0, 1) == 0 ? 1 : -1;
    tensors[0] = SymmetricTensor<double>{k * e.x * e.x, k * e.y * e.y, k * e.z * e.z,
                                         k * e.x * e.y, k * e.y * e.z, k * e.x * e.z} -
                 (tensors[1] + tensors[2] + tensors[3]);
    std::array<Vector3<double>, 4> points;
    for (auto& p : points) p = {entry(5), entry(5), entry(5)};
    const auto x = points[1] - points[0], y = points[2] - points[0], z = points[3] - points[0];
    if (dot(e, e) == 0 || dot(x, cross(y, z)) == 0) continue;
    const TetMesh mesh = single_tet_mesh(points, tensors);
    const auto exact = exact_transitions(mesh, e);
    const auto linear = counts(mesh, Degeneracy::linear), planar = counts(mesh, Degeneracy::planar);
    if (!exact || linear[2] + planar[2] > 0) {
      ++skipped;
      continue;
    }
    EXPECT_EQ(linear[0] + planar[0], static_cast<std::size_t>(*exact)) << exact_text(tensors);
    ++fields;
    for (int i = 0; i < *exact; ++i) ++zeros;
    several.count(*exact > 1);
  }
  std::cout << fields.so_far() << " fields, " << zeros.so_far() << " transitions, " << skipped
            << " fields skipped\n";
}

TEST(CurveArcs, SignsAreThoseOfVertices) {
  const std::uint64_t seed = 20261102;
  SCOPED_TRACE(announce(seed));
  Compared vertices("vertices", 1000), zeros("transitions", 25), jumps("jumps", 5);
  std::size_t not_proved = 0, lines = 0;
  for (int trial = 0; trial < trials(3); ++trial) {
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, seed + static_cast<std::uint64_t>(trial));
    for (const Degeneracy kind : kKinds) {
      const auto extraction = extract_degenerate_curves(mesh, kind);
      const CurveMesh& curves = extraction.curves;
      const auto all = curve_separation(CurveArcs(mesh, kind, curves));
      ASSERT_EQ(all.lines.size(), curves.lines.size());
      const ScaledField<double> field(mesh);
      for (std::size_t i = 0; i < curves.lines.size(); ++i) {
        const LineSeparation& line = all.lines[i];
        ++lines;
        not_proved += line.obstacle.has_value();
        if (line.obstacle) continue;
        EXPECT_EQ(line.begin * line.end, line.zeros.size() % 2 == 0 ? 1 : -1);
        const FieldInSpace space(field, as_size(curves.tet[i]));
        double largest = 0;
        std::size_t changes = 0;
        int last = line.begin;
        for (const auto v : curves.lines[i]) {
          const double value =
              space.separation(curves.points[as_size(v)], curves.dominant_eigenvector[as_size(v)]);
          largest = std::max(largest, std::abs(value));
          if (std::abs(value) < 1e-9) continue;
          const int sign = value > 0 ? 1 : -1;
          if (v == curves.lines[i].front()) {
            EXPECT_EQ(sign, line.begin);
          }
          if (v == curves.lines[i].back()) {
            EXPECT_EQ(sign, line.end);
          }
          changes += sign != last;
          last = sign;
          ++vertices;
        }
        // Samples may miss two zeros, but none is there that was not found.
        EXPECT_LE(changes, line.zeros.size());
        EXPECT_EQ(changes % 2, line.zeros.size() % 2);
        for (const PlaceBox& box : line.zeros) {
          ++zeros;
          EXPECT_LT(max_norm(box.high - box.low), 2e-8);
          EXPECT_LT(space.distance_from_degenerate(box.middle()), 1e-6);
          EXPECT_LT(distance(box.middle(), curves), 0.05);
        }
      }
      for (const SeparationJump& jump : all.jumps) {
        ++jumps;
        EXPECT_LT(max_norm(jump.place.middle() - curves.points[as_size(jump.vertex)]), 2e-8);
        EXPECT_LT(max_norm(jump.place.high - jump.place.low), 2e-8);
        // Vertices have the mean over both tetrahedra: here each by itself.
        double product = 1;
        for (const std::size_t line : jump.lines)
          product *= FieldInSpace(field, as_size(curves.tet[line]))
                         .separation(curves.points[as_size(jump.vertex)],
                                     curves.dominant_eigenvector[as_size(jump.vertex)]);
        EXPECT_LT(product, 1e-9);
      }
    }
  }
  std::cout << lines << " lines, " << zeros.so_far() << " transitions, " << jumps.so_far()
            << " jumps, " << not_proved << " lines not proved\n";
  EXPECT_EQ(not_proved, 0u);
}

TEST(CurveArcs, AreEnclosed) {
  const std::uint64_t seed = 20261103;
  SCOPED_TRACE(announce(seed));
  Compared points("points", 1000);
  TetMesh mesh = cube_mesh(3);
  fill_with_normal_tensors(mesh, seed);
  const ScaledField<double> field(mesh);
  for (const Degeneracy kind : kKinds) {
    const CurveExtraction extraction = extract_degenerate_curves(mesh, kind);
    const CurveMesh& curves = extraction.curves;
    const CurveArcs arcs(mesh, kind, curves);
    for (std::size_t i = 0; i < curves.lines.size(); ++i) {
      const auto arc = arcs.enclosed(i, 3);
      ASSERT_TRUE(arc.has_value()) << i;
      ASSERT_EQ(arc->points.size(), 9u);
      ASSERT_EQ(arc->hulls.size(), 8u);
      const auto far = [&](const PlaceBox& box, CurveMesh::Index v) {
        return max_norm(box.middle() - curves.points[as_size(v)]);
      };
      EXPECT_LT(far(arc->points.front(), curves.lines[i].front()), 2e-8);
      EXPECT_LT(far(arc->points.back(), curves.lines[i].back()), 2e-8);
      const FieldInSpace space(field, as_size(curves.tet[i]));
      for (const PlaceBox& box : arc->points) {
        ++points;
        EXPECT_LT(max_norm(box.high - box.low), 2e-8);
        EXPECT_LT(space.distance_from_degenerate(box.middle()), 1e-6);
        EXPECT_LT(distance(box.middle(), curves), 0.05);
      }
    }
  }
}

// Of a field in special position the lines say so, and no more is said of them.
RC_GTEST_PROP(CurveArcs, AreTheSameForOppositeFieldsAndOtherNumbers, ()) {
  const TetSample sample = *rc::gen::oneOf(small_integer_tet(9), normal_tet());
  const TetMesh mesh = reference_tet_mesh(sample.tensors);
  TetMesh negative = mesh;
  for (auto& t : negative.tensors) t = -1.0 * t;
  const auto linear = counts(mesh, Degeneracy::linear);
  RC_ASSERT(linear == counts(negative, Degeneracy::planar));
  RC_TAG(linear[0]);
  TetMesh rotated = mesh;
  std::rotate(rotated.tets[0].begin(), rotated.tets[0].begin() + 1, rotated.tets[0].begin() + 3);
  RC_ASSERT(linear == counts(rotated, Degeneracy::linear));
}

}  // namespace
}  // namespace tensortopo::test
