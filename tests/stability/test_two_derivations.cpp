// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "free_tets.hpp"
#include "stable_simplex.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

/// What each is told of one tetrahedron.
struct Case {
  TetMesh mesh;
  certificate::Input input;
  std::vector<double> radii;
  certificate::Radius radius;
  ModeValue mode;
  mpz_class numerator, denominator;
};

Case random_case(Random& random) {
  Case c;
  TetTensors tensors = random.tet_tensors();
  if (random.integer(0, 2) != 0) {
    const auto common = random.tensor();
    for (auto& t : tensors) t = common + 0.2 * t;
  }
  c.mesh = reference_tet_mesh(tensors);
  for (std::size_t v = 0; v < 4; ++v) {
    const auto& p = c.mesh.points[v];
    const auto& t = c.mesh.tensors[v];
    c.input.points.push_back({p.x, p.y, p.z});
    c.input.tensors.push_back({t.xx, t.yy, t.zz, t.xy, t.yz, t.xz});
  }
  c.input.tets.push_back({0, 1, 2, 3});
  c.input.cells.push_back(0);
  c.radius.of_deviator = random.integer(0, 1) == 0;
  c.radius.value = random.integer(0, 1) == 0 ? 0x1p-10 : 0x1p-5;
  c.radii = vertex_radii(
      c.mesh, {c.radius.of_deviator ? Uncertainty::Kind::relative : Uncertainty::Kind::absolute,
               c.radius.value,
               {}});
  const int k = random.integer(-19, 19);
  c.mode = ModeValue::parse(std::to_string(k) + "/20");
  c.numerator = c.mode.numerator(), c.denominator = c.mode.denominator();
  return c;
}

TEST(TwoDerivations, OfWhatIsStableAgree) {
  Compared compared("tetrahedra that the library calls stable", 50);
  Compared refuted("tetrahedra with a vertex that is not", 3);
  Random random(20261124);
  const certificate::ForAll one_by_one = [](std::size_t count, const auto& f, const char*) {
    for (std::size_t i = 0; i < count; ++i) f(i);
  };
  for (int trial = 0; trial < 150; ++trial) {
    const Case c = random_case(random);
    const Stability ours = level_stability(UncertainField(c.mesh, c.radii), c.mode).tets[0];
    const certificate::Field field(c.input, {}, one_by_one);
    const certificate::ModeBall mode(c.numerator, c.denominator);
    const auto theirs = are_free(c.input, field, mode, c.radius, {0}, one_by_one);
    if (ours == Stability::stable) {
      ++compared;
      EXPECT_EQ(theirs.answer, certificate::Answer::yes) << "trial " << trial << theirs.place;
    }
    // The reasons that are exact.
    const bool is_exact =
        ours == Stability::side_of_vertex || ours == Stability::isotropic_within_radius;
    refuted.count(is_exact);
    EXPECT_EQ(theirs.answer == certificate::Answer::no, is_exact) << "trial " << trial;
  }
}

TEST(TwoDerivations, OfStableCurvesAgree) {
  Compared compared("tetrahedra that the library calls stable", 50);
  Compared crossed("of them that hold a curve", 5);
  Compared refuted("tetrahedra with a vertex that is not", 1);
  Random random(20261125);
  const certificate::ForAll one_by_one = [](std::size_t count, const auto& f, const char*) {
    for (std::size_t i = 0; i < count; ++i) f(i);
  };
  for (int trial = 0; trial < 300; ++trial) {
    const Case c = random_case(random);
    const bool planar = trial % 2 == 1;
    const Degeneracy kind = planar ? Degeneracy::planar : Degeneracy::linear;
    const Stability ours = curve_stability(UncertainField(c.mesh, c.radii), kind).tets[0];
    const certificate::Field field(c.input, {}, one_by_one);
    const auto theirs = are_transverse(c.input, field, planar, c.radius, {0}, one_by_one);
    if (ours == Stability::stable) {
      ++compared;
      crossed.count(!extract_degenerate_curves(c.mesh, kind).curves.lines.empty());
      EXPECT_EQ(theirs.answer, certificate::Answer::yes) << "trial " << trial << theirs.place;
    }
    const bool is_exact =
        ours == Stability::degenerate_vertex || ours == Stability::isotropic_within_radius;
    refuted.count(is_exact);
    EXPECT_EQ(theirs.answer == certificate::Answer::no, is_exact) << "trial " << trial;
  }
}

}  // namespace
}  // namespace tensortopo::test
