// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "scenario.hpp"
#include "surface_pressure.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

struct Facts {
  std::size_t full_hexes, full_points, small_hexes, small_points;
  Vector3<double> size;
};

const std::map<std::string, Facts> kFacts{
    {"s1_compress", {80000, 85731, 1200, 1573, {100, 100, 100}}},
    {"s1_compress_off", {80000, 85731, 1200, 1573, {100, 100, 100}}},
    {"s2_pushpull", {75000, 81016, 1140, 1540, {150, 80, 50}}},
    {"s3_three", {64000, 69741, 1000, 1386, {160, 80, 40}}},
    {"s4_slab", {47736, 52115, 1248, 1665, {108, 68, 60}}}};

class Scenarios : public testing::TestWithParam<std::string> {};

TEST_P(Scenarios, HaveThePapersNumberOfTetrahedra) {
  const Facts& facts = kFacts.at(GetParam());
  const HexMesh full = make_scenario(GetParam(), Size::full).mesh;
  EXPECT_EQ(full.hexes.size(), facts.full_hexes);
  EXPECT_EQ(full.points.size(), facts.full_points);
  const HexMesh small = make_scenario(GetParam(), Size::small).mesh;
  EXPECT_EQ(small.hexes.size(), facts.small_hexes);
  EXPECT_EQ(small.points.size(), facts.small_points);
}

TEST_P(Scenarios, FillTheirBoxWithoutDefect) {
  for (const Size size : {Size::small, Size::full}) {
    TetMesh mesh = to_tets(make_scenario(GetParam(), size).mesh);
    mesh.tensors.resize(mesh.points.size());
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(count_unreferenced_points(mesh), 0u);
    Vector3<double> low = mesh.points.front(), high = low;
    for (const auto& p : mesh.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    EXPECT_EQ(low, (Vector3<double>{0, 0, 0}));
    EXPECT_EQ(high, kFacts.at(GetParam()).size);
  }
}

TEST_P(Scenarios, PressWithTheForceThatTheyName) {
  for (const Size size : {Size::small, Size::full}) {
    const Scenario scenario = make_scenario(GetParam(), size);
    for (const Load& load : scenario.loads) {
      Scenario alone = scenario;
      alone.loads = {load};
      const Wrench sum = resultant(alone.mesh, surface_pressures(alone));
      EXPECT_NEAR(sum.force.z, -load.force, 1e-12 * std::abs(load.force));
      EXPECT_EQ(sum.force.x, 0);
      EXPECT_EQ(sum.force.y, 0);
    }
  }
}

// The resultant acts at the patch's centre, to half the distance of samples: 20 on each side of
// a face of at most 2.5 mm.
TEST_P(Scenarios, PressWhereTheySay) {
  const Scenario scenario = make_scenario(GetParam(), Size::full);
  for (Load load : scenario.loads) {
    if (load.shape == Load::Shape::everywhere) load.x = 54, load.y = 34;
    Scenario alone = scenario;
    alone.loads = {load};
    const Wrench sum = resultant(alone.mesh, surface_pressures(alone));
    EXPECT_NEAR(-sum.moment.y / sum.force.z, load.x, 0.0625);
    EXPECT_NEAR(sum.moment.x / sum.force.z, load.y, 0.0625);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Scenarios, testing::ValuesIn(scenario_names()),
                         [](const auto& test) { return test.param; });

TEST(Scenario, OnePressedPatchIsUniform) {
  const Scenario scenario = make_scenario("s1_compress", Size::full);
  const auto pressures = surface_pressures(scenario);
  EXPECT_EQ(pressures.size(), 64u);  // 20 mm by 20 mm, of faces 2.5 mm by 2.5 mm
  for (const auto& [hex, pressure] : pressures) EXPECT_DOUBLE_EQ(pressure, 250);
}

TEST(Scenario, PushAndPullAreOpposite) {
  const Scenario scenario = make_scenario("s2_pushpull", Size::full);
  std::map<std::array<double, 2>, double> at;
  for (const auto& [hex, pressure] : surface_pressures(scenario)) {
    const auto face = top_face(scenario.mesh, hex);
    // The lattice has a column of hexahedra in the middle, so the mirror image of a face is one.
    const double x = std::round(1000 * (face[0].x + face[1].x) / 2);
    at[{x, face[0].y}] = pressure;
  }
  EXPECT_FALSE(at.empty());
  for (const auto& [place, pressure] : at) {
    const auto mirror = at.find({150000 - place[0], place[1]});
    ASSERT_NE(mirror, at.end());
    EXPECT_NEAR(mirror->second, -pressure, 1e-9);
    EXPECT_EQ(pressure > 0, place[0] < 75000);
  }
}

TEST(Scenario, ALoadBesideTheBlockIsRefused) {
  Scenario scenario = make_scenario("s1_compress", Size::small);
  scenario.loads.front().x = 500;
  EXPECT_THROW(surface_pressures(scenario), std::invalid_argument);
}

TEST(Scenario, AnUnknownNameIsRefused) {
  EXPECT_THROW(make_scenario("s5", Size::small), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
