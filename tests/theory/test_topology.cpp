// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Certified complexes of levels of the mode, on surfaces whose topology is known.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tensors.hpp"
#include "topology/boundary_curve.hpp"
#include "levels/level_surface.hpp"
#include "topology/signature.hpp"
#include "levels/tensor_sphere.hpp"

namespace tensortopo::theory {
namespace {

const Basis kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

SpanBasis basis_across(int l1, int l2, const Basis& frame = kAxes) {
  const std::array<Rational, 3> values = {Rational(l1), Rational(l2), Rational(-l1 - l2)};
  return span_basis(deviator(tensor_of(values, frame)));
}

LevelSurface closed_surface(int euler) {
  return {.euler = euler, .components = 1, .closed_components = 1};
}
LevelSurface double_torus() { return closed_surface(-2); }
LevelSurface torus() { return closed_surface(0); }

LevelSurface sheets(int euler, int components, int loops) {
  return {.euler = euler, .components = components, .boundary_loops = loops};
}

// origin + x t1 + y t2 + z t3 at four corners of the box (+-x, +-y, +-z).
std::array<Deviator<Rational>, 4> tetrahedron(const std::array<Tensor, 4>& field, int x, int y,
                                              int z) {
  std::array<Deviator<Rational>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const int sx = i < 2 ? 1 : -1, sy = i % 2 == 0 ? 1 : -1;
    result[i] = deviator(field[0] + Rational(sx * x) * field[1] + Rational(sy * y) * field[2] +
                         Rational(sx * sy * z) * field[3]);
  }
  return result;
}

// [[11, x, y], [x, -13, z], [y, z, 2]]: its mode has a saddle at the origin, of mode -143/343.
const std::array<Tensor, 4> kSaddle = {Tensor{11, -13, 2, 0, 0, 0}, Tensor{0, 0, 0, 1, 0, 0},
                                       Tensor{0, 0, 0, 0, 0, 1}, Tensor{0, 0, 0, 0, 1, 0}};

// [[11 x, y, -1 - 5 x], [y, -13 x, z], [-1 - 5 x, z, 2 x]].
const std::array<Tensor, 4> kHandle = {Tensor{0, 0, 0, 0, 0, -1}, Tensor{11, -13, 2, 0, 0, -5},
                                       Tensor{0, 0, 0, 1, 0, 0}, Tensor{0, 0, 0, 0, 1, 0}};

// [[4 z, 1, x], [1, -5 z, y], [x, y, z]]: tubes around degenerate lines.
const std::array<Tensor, 4> kTubes = {Tensor{0, 0, 0, 1, 0, 0}, Tensor{0, 0, 0, 0, 0, 1},
                                      Tensor{0, 0, 0, 0, 1, 0}, Tensor{4, -5, 1, 0, 0, 0}};

ModeLevel level_of(int numerator, int denominator) {
  return {squared(fraction(numerator, denominator)), numerator < 0 ? -1 : 1};
}

TEST(Signature, CountsSquares) {
  EXPECT_EQ(signature({{1, 2}, {2, 1}}), (Signature{1, 1, 0}));
  EXPECT_EQ(signature({{0, 1}, {1, 0}}), (Signature{1, 1, 0}));
  EXPECT_EQ(signature({{1, 1}, {1, 1}}), (Signature{1, 0, 1}));
  EXPECT_EQ(signature({{2, 1, 0}, {1, 2, 1}, {0, 1, 2}}), (Signature{3, 0, 0}));
  EXPECT_EQ(signature({{0, 0}, {0, 0}}), (Signature{0, 0, 2}));
}

RC_GTEST_PROP(Signature, IsThatOfTheEigenvaluesInAnyBasis, (std::uint64_t seed)) {
  Random random(seed);
  std::array<Rational, 3> values = {random.fraction(), random.fraction(), random.fraction()};
  const Tensor t = tensor_of(values, random_basis(random));
  Signature expected;
  for (const Rational& v : values) {
    ++(v > 0 ? expected.positive : v < 0 ? expected.negative : expected.zero);
  }
  RC_ASSERT(signature({{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}) == expected);
}

Deviator<Rational> random_deviator(Random& random) {
  return {random.fraction(), random.fraction(), random.fraction(), random.fraction(),
          random.fraction()};
}

// The sign of sqrt(2) Q - mu P^(3/2) from a comparison of squares, written another way.
bool is_above_by_squares(const Deviator<Rational>& t, const ModeLevel& level) {
  const Tensor full = to_tensor(t);
  const Rational det = determinant(full);
  const Rational signed_square = det < 0 ? Rational(-mode_squared(full)) : mode_squared(full);
  return signed_square > Rational(level.sign) * level.mu_squared;
}

RC_GTEST_PROP(ModeLevel, SidesAgreeWithTheSquaredMode, (std::uint64_t seed)) {
  Random random(seed);
  const Deviator<Rational> t = random_deviator(random);
  RC_PRE(norm_form(t) != 0);
  const ModeLevel level = ModeLevel::of_parameter(random.part(), random.integer(0, 1) ? 1 : -1);
  const Deviator<Integer> whole = primitive(t);
  const bool above = is_above_by_squares(t, level);
  if (!level.is_neutral()) RC_ASSERT(is_above(whole, level) == above);
  const Verdict quick =
      side(bounded(whole, binary_size(whole)), level, enclosing<Bounded<double>>(level.mu_squared));
  if (quick == Verdict::positive) RC_ASSERT(is_above(whole, level));
  if (quick == Verdict::negative) RC_ASSERT(!is_above(whole, level));
}

TEST(ModeLevel, TensorsOnItCountAsBelow) {
  // Eigenvalues 11, 2 and -13 have mode -143/343.
  const Deviator<Integer> t = primitive(deviator(Tensor{11, 2, -13, 0, 0, 0}));
  EXPECT_FALSE(is_above(t, level_of(-143, 343)));
  EXPECT_TRUE(is_above(t, level_of(-144, 343)));
  EXPECT_FALSE(is_above(Integer(-1) * t, level_of(143, 343)));
  EXPECT_TRUE(is_above(Integer(-1) * t, level_of(142, 343)));
  EXPECT_FALSE(is_above(primitive(deviator(Tensor{1, -1, 0, 0, 0, 0})), ModeLevel::neutral()));
}

TEST(ModeLevel, BoundsHoldForHugeEntries) {
  const Integer huge = Integer(1) << 5000;
  const Deviator<Integer> t = {huge, Integer(-3), huge + 1, Integer(0), Integer(7)};
  const BoundedDeviator b = bounded(t, binary_size(t));
  EXPECT_EQ(b.a.value, 1);
  EXPECT_GT(b.xy.error, 0);
  EXPECT_GT(b.b.error, 0);
  EXPECT_EQ(certified_sign(b.yz), Verdict::zero);
}

RC_GTEST_PROP(SimplexProof, HoldsAtRandomPoints, (std::uint64_t seed)) {
  Random random(seed);
  // Close to each other, so that something is proved.
  const Deviator<Rational> centre = random_deviator(random);
  std::array<Deviator<Integer>, 4> vertices;
  std::array<BoundedDeviator, 4> near;
  for (std::size_t i = 0; i < 4; ++i) {
    vertices[i] = primitive(centre + fraction(1, 4) * random_deviator(random));
    near[i] = bounded(vertices[i], binary_size(vertices[i]));
  }
  const ModeLevel level = ModeLevel::of_parameter(random.part());
  const SimplexProof proof = prove<4>(near, level, enclosing<Bounded<double>>(level.mu_squared));
  RC_CLASSIFY(proof == SimplexProof::empty, "empty");
  RC_CLASSIFY(proof == SimplexProof::monotone, "monotone");
  if (proof != SimplexProof::empty) return;
  const bool above = is_above(vertices[0], level);
  for (int i = 0; i < 30; ++i) {
    Deviator<Integer> t;
    for (const auto& v : vertices) t = t + Integer(random.integer(0, 20)) * v;
    if (norm_form(t) != 0) RC_ASSERT(is_above(t, level) == above);
  }
}

TEST(SimplexProof, CountsCrossingsOfAnEdge) {
  const ModeLevel level = level_of(4, 5);
  // Along x xz + 3/2 yz + xy the mode is 3 sqrt(3) (3/2) x / (x^2 + 13/4)^(3/2).
  const auto at = [](int x) {
    return primitive(deviator(Tensor{0, 0, 0, 1, fraction(3, 2), Rational(x)}));
  };
  const auto count = [&](int from, int to) {
    const Deviator<Integer> u = at(from), v = at(to);
    return crossings({bounded(u, binary_size(u)), bounded(v, binary_size(v))},
                     {is_above(u, level), is_above(v, level)}, level,
                     enclosing<Bounded<double>>(level.mu_squared));
  };
  EXPECT_EQ(count(-5, 0), 0);
  EXPECT_EQ(count(0, 1), 1);
  EXPECT_EQ(count(1, 6), 1);
  EXPECT_GE(count(0, 6), 2);
}

RC_GTEST_PROP(SpanBasis, IsIndependentAndOrthogonal, (std::uint64_t seed)) {
  Random random(seed);
  const Deviator<Rational> normal = random_deviator(random);
  RC_PRE(norm_form(normal) != 0);
  const SpanBasis basis = span_basis(normal);
  std::vector<std::vector<Rational>> gram(4, std::vector<Rational>(4));
  for (std::size_t i = 0; i < 4; ++i) {
    RC_ASSERT(norm_form(basis[i], primitive(normal)) == 0);
    for (std::size_t j = 0; j < 4; ++j) gram[i][j] = Rational(norm_form(basis[i], basis[j]));
  }
  RC_ASSERT((signature(gram) == Signature{4, 0, 0}));
}

// Eigenvalues of the characteristic tensor, a mode, and what the surface is there by the formula
// s0 = (l1 - l2) / (l1 + l2); Euler characteristics were also found on grids of cubes.
struct SphereCase {
  int l1, l2;
  Rational s;
  int euler;
};

TEST(SphereSurface, IsATorusAboveTheCriticalModeAndADoubleTorusBelow) {
  const std::vector<SphereCase> cases = {
      {5, 3, fraction(1, 50), -2}, {5, 3, fraction(1, 8), -2},  {5, 3, fraction(1, 5), -2},
      {5, 3, fraction(3, 10), 0},  {5, 3, fraction(4, 5), 0},   {2, 1, fraction(1, 5), -2},
      {2, 1, fraction(1, 2), 0},   {9, 1, fraction(1, 2), -2},  {9, 1, fraction(7, 8), 0},
      {9, 8, fraction(1, 25), -2}, {9, 8, fraction(1, 10), 0},  {1, 0, fraction(1, 2), -2},
      {1, 0, fraction(9, 10), -2}, {1, 1, fraction(1, 20), 0},  {1, 1, fraction(3, 4), 0},
      {20, 1, fraction(3, 4), -2}, {20, 19, fraction(1, 5), 0},
  };
  for (const auto& [l1, l2, s, euler] : cases) {
    const auto surface = sphere_surface(basis_across(l1, l2), ModeLevel::of_parameter(s));
    ASSERT_TRUE(surface) << l1 << ", " << l2 << ", s = " << s;
    EXPECT_EQ(*surface, closed_surface(euler))
        << l1 << ", " << l2 << ", s = " << s << ": " << text(*surface);
  }
}

TEST(SphereSurface, ChangesWithinTwoHundredthsOfTheCriticalMode) {
  for (const auto& [l1, l2] : {std::array{5, 3}, std::array{2, 1}, std::array{4, 1}}) {
    const Rational s0 = fraction(l1 - l2, l1 + l2);
    const SpanBasis basis = basis_across(l1, l2);
    const auto at = [&](int hundredths) {
      return sphere_surface(basis, ModeLevel::of_parameter(s0 * fraction(hundredths, 100)));
    };
    EXPECT_EQ(at(98), double_torus()) << l1 << ", " << l2;
    EXPECT_EQ(at(102), torus()) << l1 << ", " << l2;
  }
}

TEST(SphereSurface, ChangesWithinAMillionthOfTheCriticalMode) {
  const SpanBasis basis = basis_across(5, 3);
  const Rational s0 = fraction(1, 4), step = fraction(1, 4000000);
  EXPECT_EQ(sphere_surface(basis, ModeLevel::of_parameter(s0 - step)), double_torus());
  EXPECT_EQ(sphere_surface(basis, ModeLevel::of_parameter(s0 + step)), torus());
}

TEST(SphereSurface, IsUndecidedAtTheCriticalMode) {
  const ModeLevel critical = ModeLevel::of_parameter(fraction(1, 4));
  EXPECT_EQ(sphere_surface(basis_across(5, 3), critical, 30000), std::nullopt);
  // The neutral surface of a planar degenerate characteristic tensor crosses itself.
  EXPECT_EQ(sphere_surface(basis_across(1, 1), ModeLevel::neutral(), 30000), std::nullopt);
  EXPECT_EQ(projective_neutral_surface(basis_across(1, 1), 30000), std::nullopt);
}

TEST(SphereSurface, IsUndecidedIfTheBudgetIsSmall) {
  const ModeLevel level = ModeLevel::of_parameter(fraction(1, 8));
  EXPECT_EQ(sphere_surface(basis_across(5, 3), level, 100), std::nullopt);
}

TEST(NeutralSurface, IsAProjectivePlaneWithAHandle) {
  const LevelSurface expected = {
      .euler = -1, .components = 1, .closed_components = 1, .orientable = false};
  for (const auto& [l1, l2] :
       {std::array{5, 3}, std::array{2, 1}, std::array{1, 0}, std::array{9, 1}, std::array{9, 8}}) {
    const auto surface = projective_neutral_surface(basis_across(l1, l2));
    ASSERT_TRUE(surface);
    EXPECT_EQ(*surface, expected) << l1 << ", " << l2 << ": " << text(*surface);
    EXPECT_EQ(sphere_surface(basis_across(l1, l2), ModeLevel::neutral()), double_torus());
  }
}

TEST(SphereSurface, DoesNotDependOnRotationScaleOrSign) {
  Random random(3);
  const ModeLevel below = ModeLevel::of_parameter(fraction(1, 5)),
                  above = ModeLevel::of_parameter(fraction(1, 2));
  for (int i = 0; i < 8; ++i) {
    const Basis frame = random_basis(random);
    const Rational scale = Rational(random.nonzero(9)) / Rational(random.integer(1, 1000));
    const SpanBasis basis =
        span_basis(deviator(scale * tensor_of({Rational(2), Rational(1), Rational(-3)}, frame)));
    EXPECT_EQ(sphere_surface(basis, below), double_torus()) << text(frame[0]);
    EXPECT_EQ(sphere_surface(basis, above), torus()) << text(frame[0]);
    const ModeLevel opposite = {below.mu_squared, -1};
    EXPECT_EQ(sphere_surface(basis, opposite), double_torus()) << text(frame[0]);
  }
}

TEST(SphereSurface, DoesNotDependOnTheBasis) {
  Random random(5);
  const SpanBasis round = basis_across(5, 3);
  for (int i = 0; i < 6; ++i) {
    SpanBasis basis;
    // Far from the identity by less than it is from singular.
    for (std::size_t r = 0; r < 4; ++r) {
      basis[r] = Integer(10) * round[r];
      for (const auto& b : round) basis[r] = basis[r] + Integer(random.integer(-3, 2)) * b;
    }
    EXPECT_EQ(sphere_surface(basis, ModeLevel::of_parameter(fraction(1, 8))), double_torus());
    EXPECT_EQ(sphere_surface(basis, ModeLevel::of_parameter(fraction(1, 2))), torus());
  }
}

TEST(LevelComplex, IsAClosedManifoldAfterRefinement) {
  LevelComplex complex = tensor_sphere(basis_across(5, 3), ModeLevel::of_parameter(fraction(1, 8)));
  ASSERT_TRUE(complex.refine(kCellBudget));
  std::map<std::uint64_t, int> faces;
  std::set<std::uint64_t> edges;
  std::set<LevelComplex::Index> vertices;
  const auto cells = complex.cells();
  for (const auto& c : cells) {
    for (std::size_t i = 0; i < 4; ++i) {
      vertices.insert(c[i]);
      for (std::size_t j = i + 1; j < 4; ++j) {
        edges.insert(simplex_key(std::array{c[i], c[j]}));
        for (std::size_t k = j + 1; k < 4; ++k) ++faces[simplex_key(std::array{c[i], c[j], c[k]})];
      }
    }
  }
  for (const auto& [face, count] : faces) ASSERT_EQ(count, 2);
  EXPECT_EQ(vertices.size() + faces.size(), edges.size() + cells.size());
  for (const auto v : vertices) {
    const auto& t = complex.tensor(v);
    EXPECT_EQ(complex.is_above(v), is_above(t, ModeLevel::of_parameter(fraction(1, 8))));
  }
}

// Components, Euler characteristic and boundary loops as found on fine grids.
TEST(TetrahedronSurface, AgreesWithGrids) {
  const auto saddle = tetrahedron(kSaddle, 1, 1, 1), larger = tetrahedron(kSaddle, 2, 2, 2);
  const auto handle = tetrahedron(kHandle, 3, 24, 11), tubes = tetrahedron(kTubes, 3, 3, 3);
  const auto expect = [](const std::array<Deviator<Rational>, 4>& field, const ModeLevel& level,
                         const LevelSurface& expected) {
    const auto surface = tetrahedron_surface(field, level);
    ASSERT_TRUE(surface);
    EXPECT_EQ(*surface, expected) << "mode^2 " << level.mu_squared << ": " << text(*surface);
  };
  const LevelSurface discs = sheets(2, 2, 2), cylinder = sheets(0, 1, 2);
  expect(saddle, level_of(-415, 1000), discs);
  expect(saddle, level_of(-416, 1000), cylinder);
  expect(saddle, level_of(-418, 1000), discs);
  expect(saddle, level_of(-420, 1000), discs);
  expect(larger, level_of(-415, 1000), cylinder);
  expect(larger, level_of(-416, 1000), cylinder);
  expect(larger, level_of(-418, 1000), discs);
  expect(handle, level_of(632269, 2685619), sheets(-2, 1, 2));
  expect(handle, level_of(2, 5), sheets(-2, 1, 2));
  expect(handle, level_of(43, 100), cylinder);
  expect(tubes, level_of(99, 100), sheets(0, 2, 4));
  expect(tubes, level_of(-99, 100), sheets(0, 2, 4));
  // No mode beyond these is in the tetrahedron of the saddle.
  expect(saddle, level_of(9, 10), sheets(0, 0, 0));
}

// A face whose mode has a maximum of 0.8477 inside: a level just below makes a closed curve in it
// that meets no edge, also in a cell along which the mode is monotone.
TEST(TetrahedronSurface, MayMeetAFaceInsideItsEdges) {
  const auto at = [](const Rational& x, const Rational& y) {
    return Tensor{-1, 2, -1, 0, 1, 1} + x * Tensor{0, 1, -1, 2, 0, 1} +
           y * Tensor{1, 0, -1, -1, 1, 2};
  };
  const auto surface_with = [&](const Rational& height) {
    const Tensor apex = at(fraction(1, 8), fraction(-19, 50)) + height * Tensor{0, 1, -1, 0, 0, 0};
    return tetrahedron_surface({deviator(at(fraction(-2, 5), fraction(-9, 10))),
                                deviator(at(fraction(4, 5), fraction(-9, 10))),
                                deviator(at(fraction(1, 5), fraction(3, 10))), deviator(apex)},
                               level_of(84, 100));
  };
  EXPECT_EQ(surface_with(fraction(-1, 2)), sheets(1, 1, 1));
  EXPECT_EQ(surface_with(fraction(1, 2)), sheets(0, 1, 2));
}

TEST(TetrahedronSurface, IsUndecidedAtTheSaddle) {
  EXPECT_EQ(tetrahedron_surface(tetrahedron(kSaddle, 1, 1, 1), level_of(-143, 343), 20000),
            std::nullopt);
}

TEST(TetrahedronSurface, IsUndecidedWhereTheFieldVanishes) {
  auto field = tetrahedron(kSaddle, 1, 1, 1);
  field[2] = {};
  EXPECT_EQ(tetrahedron_surface(field, level_of(1, 2), 5000), std::nullopt);
}

RC_GTEST_PROP(TetrahedronSurface, DoesNotDependOnTheOrderOfVertices, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Trial trial = random_trial(random.next(), static_cast<std::size_t>(random.integer(0, 8)));
  auto vertices = trial.field.vertex;
  const ModeLevel level = ModeLevel::of_parameter(fraction(random.integer(100, 900), 1009));
  const auto first = tetrahedron_surface(vertices, level);
  std::rotate(vertices.begin(), vertices.begin() + random.integer(1, 3), vertices.end());
  RC_ASSERT(first.has_value());
  RC_ASSERT(tetrahedron_surface(vertices, level) == first);
  RC_ASSERT(first->closed_components == 0);
}

TEST(LoopIsInside, OnlyForTheLoopThatIs) {
  std::array<Tensor, 4> corners;
  const auto field = tetrahedron(kHandle, 3, 24, 11);
  for (std::size_t i = 0; i < 4; ++i) corners[i] = to_tensor(field[i]);
  EXPECT_TRUE(loop_is_inside({5, 3, -8}, fraction(6, 25), corners, 1));
  EXPECT_FALSE(loop_is_inside({5, 3, -8}, fraction(6, 25), corners, -1));
  EXPECT_FALSE(loop_is_outside({5, 3, -8}, fraction(6, 25), corners, 1));
  // Above the critical mode the loops are one.
  EXPECT_FALSE(loop_is_inside({5, 3, -8}, fraction(1, 2), corners, 1));
  // In a smaller tetrahedron the loop leaves it.
  const auto small = tetrahedron(kHandle, 1, 2, 1);
  for (std::size_t i = 0; i < 4; ++i) corners[i] = to_tensor(small[i]);
  EXPECT_FALSE(loop_is_inside({5, 3, -8}, fraction(6, 25), corners, 1));
}

}  // namespace
}  // namespace tensortopo::theory
