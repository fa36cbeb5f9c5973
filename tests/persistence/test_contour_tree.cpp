// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/persistence/contour_tree.hpp"
#include "tensortopo/persistence/linking_number.hpp"

namespace tensortopo::test {
namespace {

// Another computation that shares nothing with the tree but critical points: each arc across a mode
// is a component of its surface.
TEST(ContourTree, ArcsAreComponentsOfSurfaces) {
  const auto count_of = [](int count) { return static_cast<std::size_t>(trials(count, count / 2)); };
  Compared compared("components", count_of(100)),
      several("surfaces of several components", count_of(10));
  Compared complete("complete trees", count_of(5));
  for (std::uint64_t seed = 1; seed <= count_of(6); ++seed) {
    TetMesh mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, seed);
    const ContourTree tree = contour_tree(mesh, persistence_input(mesh));
    complete.count(tree.is_complete);
    // A path that is not found makes it incomplete.
    if (!tree.is_complete) continue;
    EXPECT_EQ(tree.arcs.size() + 1, tree.nodes.size()) << seed;
    for (const char* mode : {"-0.97", "-0.8", "-0.2", "0.6", "0.98"}) {
      const auto level = extract_mode_surface<double>(mesh, ModeValue::parse(mode));
      ASSERT_TRUE(level.unresolved.empty());
      const auto components = surface_invariants(level.surface).components;
      EXPECT_EQ(tree.arcs_across(std::stod(mode)).size(), components) << seed << ' ' << mode;
      for (std::size_t i = 0; i < components; ++i) ++compared;
      several.count(components > 1);
    }
  }
}

std::vector<Vector3<double>> circle(const Vector3<double>& centre, const Vector3<double>& u,
                                    const Vector3<double>& v, int turns = 1) {
  std::vector<Vector3<double>> points;
  for (int i = 0; i < 40 * turns; ++i) {
    const double t = 2 * std::numbers::pi * i / 40;
    points.push_back(centre +
                     (1 + 0.1 * std::sin(t / turns)) * (std::cos(t) * u + std::sin(t) * v));
  }
  return points;
}

TEST(LinkingNumber, OfCircles) {
  const Vector3<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const auto a = circle({0, 0, 0}, x, y), b = circle({1, 0, 0}, x, z),
             far = circle({3, 0, 0}, x, z);
  const auto linked = linking_number(a, b);
  ASSERT_TRUE(linked.has_value());
  EXPECT_EQ(std::abs(*linked), 1);
  EXPECT_EQ(linking_number(b, a), linked);
  auto back = b;
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(linking_number(a, back), std::optional<int>(-*linked));
  EXPECT_EQ(linking_number(a, far), std::optional<int>(0));
  EXPECT_EQ(linking_number(a, a), std::nullopt);
  // Three times around, in a spiral.
  auto thrice = circle({1, 0, 0}, x, z, 3);
  EXPECT_EQ(linking_number(a, thrice), std::optional<int>(3 * *linked));
}

}  // namespace
}  // namespace tensortopo::test
