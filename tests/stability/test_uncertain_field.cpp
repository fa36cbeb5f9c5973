// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/compared.hpp"
#include "support/generators.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

double deviator_norm(const SymmetricTensor<double>& t) {
  return std::sqrt(norm_form(deviator(t)) / 3);
}

TEST(VertexRadii, AreAbsoluteOrSharesOfDeviators) {
  const TetMesh mesh = reference_tet_mesh(Random(5).tet_tensors());
  EXPECT_EQ(vertex_radii(mesh, {Uncertainty::Kind::absolute, 0.25, {}}),
            std::vector<double>(4, 0.25));
  const auto relative = vertex_radii(mesh, {Uncertainty::Kind::relative, 0.25, {}});
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_NEAR(relative[v], 0.25 * deviator_norm(mesh.tensors[v]), 1e-10);
  EXPECT_THROW(vertex_radii(mesh, {Uncertainty::Kind::absolute, -1, {}}), std::invalid_argument);
  EXPECT_THROW(
      vertex_radii(mesh,
                   {Uncertainty::Kind::relative, std::numeric_limits<double>::infinity(), {}}),
      std::invalid_argument);
  EXPECT_THROW(vertex_radii(mesh, {Uncertainty::Kind::per_vertex, 0, {1, 2, 3}}),
               std::invalid_argument);
  EXPECT_THROW(vertex_radii(mesh, {Uncertainty::Kind::per_vertex, 0, {1, 2, 3, NAN}}),
               std::invalid_argument);
}

TEST(LevelStability, IsNothingWhereDeviatorsAreNotLargerThanTheRadius) {
  TetMesh mesh = cube_mesh(1);
  fill_with_smooth_tensors(mesh, 11);
  const std::size_t smallest = [&] {
    std::size_t v = 0;
    for (std::size_t w = 1; w < mesh.tensors.size(); ++w)
      if (deviator_norm(mesh.tensors[w]) < deviator_norm(mesh.tensors[v])) v = w;
    return v;
  }();
  std::vector<double> radii(mesh.tensors.size(), 0);
  radii[smallest] = deviator_norm(mesh.tensors[smallest]) * (1 + 1e-9);
  Compared compared("tetrahedra around the vertex");
  for (const char* mode : {"0", "1/2", "-99/100"}) {
    const auto stability = level_stability(UncertainField(mesh, radii), ModeValue::parse(mode));
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const auto& tet = mesh.tets[t];
      const bool around =
          std::find(tet.begin(), tet.end(), static_cast<TetMesh::Index>(smallest)) != tet.end();
      compared.count(around);
      EXPECT_EQ(stability.tets[t] == Stability::isotropic_within_radius, around);
    }
  }
  // Multiples of the identity are isotropic, whatever the radius.
  mesh.tensors[smallest] = {3, 3, 3, 0, 0, 0};
  radii[smallest] = 0;
  const auto stability = level_stability(UncertainField(mesh, radii), ModeValue::parse("1/2"));
  EXPECT_NE(
      std::count(stability.tets.begin(), stability.tets.end(), Stability::isotropic_within_radius),
      0);
}

// Within arcsin(e / |D|) of the level's Lode angle or not: the bound is attained.
RC_GTEST_PROP(LevelStability, OfAVertexIsThatOfItsLodeAngle, ()) {
  const auto sample = *normal_tet();
  const double m = *mode_value();
  const double share = *rc::gen::element(1e-6, 1e-3, 0.05, 0.3, 0.8);
  const auto& tensor = sample.tensors[0];
  RC_PRE(deviator_norm(tensor) > 0.0);
  // The same tensor everywhere: what is not the vertices' is then stable with them.
  const TetMesh mesh = reference_tet_mesh({tensor, tensor, tensor, tensor});
  const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
  const auto mu = ModeValue::parse(std::to_string(m));
  const auto stability = level_stability(UncertainField(mesh, radii), mu).tets[0];
  const double gap = std::abs(UncertainField(mesh, radii).lode_angles[0] -
                              std::acos(mu.approx()) / 3),
               reach = std::asin(share);
  RC_PRE(std::abs(gap - reach) > 1e-6);
  RC_ASSERT((stability == Stability::stable) == (gap > reach));
}

// The level, the radii and the tensors' sizes may change together.
RC_GTEST_PROP(LevelStability, DoesNotDependOnTheUnit, ()) {
  const auto sample = *normal_tet();
  const auto mu = ModeValue::parse(std::to_string(*mode_value()));
  const int exponent = *rc::gen::inRange(-200, 200);
  TetMesh mesh = reference_tet_mesh(sample.tensors), scaled = mesh;
  auto radii = vertex_radii(mesh, {Uncertainty::Kind::absolute, 0.01, {}}), scaled_radii = radii;
  for (std::size_t v = 0; v < 4; ++v) {
    scaled.tensors[v] = std::ldexp(1.0, exponent) * mesh.tensors[v];
    scaled_radii[v] = std::ldexp(radii[v], exponent);
  }
  RC_ASSERT(level_stability(UncertainField(mesh, radii), mu).tets ==
            level_stability(UncertainField(scaled, scaled_radii), mu).tets);
}

}  // namespace
}  // namespace tensortopo::test
