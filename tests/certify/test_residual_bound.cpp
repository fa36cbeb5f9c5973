// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/residual_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/quadric/extract_invariant_surface.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::test {
namespace {

/// The tensor at a vertex' doubles, in the linear field of a tetrahedron, exactly.
SymmetricTensor<Rational> exact_tensor(const TetMesh& mesh, TetMesh::Index tet,
                                       const Vector3<double>& x) {
  const auto& v = mesh.tets[as_size(tet)];
  std::array<Vector3<Rational>, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = vector_cast<Rational>(mesh.points[as_size(v[i])]);
  const auto at = vector_cast<Rational>(x);
  const auto volume = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    return Rational(dot(b - a, cross(c - a, d - a)));
  };
  const Rational all = volume(p[0], p[1], p[2], p[3]);
  SymmetricTensor<Rational> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    auto moved = p;
    moved[i] = at;
    const Rational weight = volume(moved[0], moved[1], moved[2], moved[3]) / all;
    sum = sum + weight * tensor_cast<Rational>(mesh.tensors[as_size(v[i])]);
  }
  return sum;
}

Real50 mode_of(const SymmetricTensor<Rational>& t) {
  const auto d = deviator(t);
  const Real50 p(norm_form(d)), q(determinant_form(d));
  return sqrt(Real50(2)) * q / (p * sqrt(p));
}

template <class Value>
double largest_residual(const TetMesh& mesh, const SurfaceMesh& surface, const Value& value,
                        const Real50& wanted) {
  double largest = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const auto v : surface.triangles[t]) {
      const auto found = value(exact_tensor(mesh, surface.tet[t], surface.points[as_size(v)]));
      largest = std::max(largest, static_cast<double>(abs(found - wanted)));
    }
  return largest;
}

/// A bound, and a sharp one, of what is exactly so at the coordinates as they are, whether these
/// are the extractor's or somebody moved them; and whatever the units.
TEST(ResidualBound, HoldsAndIsSharp) {
  std::size_t compared = 0;
  for (const char* text : {"1/2", "0", "-9/10"})
    for (const double unit : {1.0, 1e-7, 3e9}) {
      TetMesh mesh = cube_mesh(1);
      fill_with_normal_tensors(mesh, 17 + static_cast<std::uint64_t>(compared));
      for (auto& p : mesh.points) p = unit * p;
      for (auto& t : mesh.tensors) t = (1 / unit) * t;
      const auto mode = ModeValue::parse(text);
      auto surface = extract_mode_surface<double>(mesh, mode).surface;
      ASSERT_FALSE(surface.triangles.empty());
      const Real50 mu = Real50(mode.approx());
      for (const double by : {0.0, 1e-6 * unit, 1e-2 * unit}) {
        for (auto& p : surface.points) p.x += by;
        const double exact = largest_residual(mesh, surface, mode_of, mu);
        const double bound = residual_bound(mesh, mode, surface);
        EXPECT_LE(exact, bound) << text << ' ' << unit << ' ' << by;
        EXPECT_LE(bound, 1.001 * exact + 1e-11) << text << ' ' << unit << ' ' << by;
        ++compared;
      }
    }
  EXPECT_EQ(compared, 27u);
}

TEST(ResidualBound, OfOtherInvariants) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 5);
  const auto magnitude = [](const auto& t) { return Real50(sqrt(Real50(inner(t, t)))); };
  const auto level = InvariantLevel::parse(Invariant::magnitude, "2");
  auto surface = extract_invariant_surface(mesh, level).surface;
  ASSERT_FALSE(surface.triangles.empty());
  for (const double by : {0.0, 1e-3}) {
    for (auto& p : surface.points) p.y += by;
    const double exact = largest_residual(mesh, surface, magnitude, 2);
    const double bound = residual_bound(mesh, level, surface);
    EXPECT_LE(exact, bound);
    EXPECT_LE(bound, 1.001 * exact + 1e-11);
  }
}

/// Also where squares of tensors overflow or underflow.
TEST(ResidualBound, OfOtherInvariantsInAnyUnits) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 5);
  const auto magnitude = [](const auto& t) { return Real50(sqrt(Real50(inner(t, t)))); };
  auto surface =
      extract_invariant_surface(mesh, InvariantLevel::parse(Invariant::magnitude, "2")).surface;
  ASSERT_FALSE(surface.triangles.empty());
  for (auto& p : surface.points) p.y += 1e-3;
  for (const auto& [unit, text] : {std::pair{1e306, "1e300"}, std::pair{1e-306, "1e-300"}}) {
    const auto level = InvariantLevel::parse(Invariant::magnitude, text);
    TetMesh scaled = mesh;
    for (auto& t : scaled.tensors) t = unit * t;
    const double exact = largest_residual(scaled, surface, magnitude, Real50(level.approx()));
    const double bound = residual_bound(scaled, level, surface);
    EXPECT_LE(exact, bound) << text;
    EXPECT_LE(bound, 1.001 * exact) << text;
  }
}

}  // namespace
}  // namespace tensortopo::test
