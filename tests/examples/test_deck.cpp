// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "deck.hpp"
#include "surface_pressure.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

RC_GTEST_PROP(Deck, NumbersFitInTwentyCharactersAndReadBack, (double x)) {
  RC_PRE(std::isfinite(x));
  const std::string text = deck_number(x);
  RC_ASSERT(text.size() <= 20u);
  const double back = std::strtod(text.c_str(), nullptr);
  // With sign, point and exponent thirteen digits are left at worst.
  RC_ASSERT(std::abs(back - x) <= 1e-12 * std::abs(x));
}

TEST(Deck, CoordinatesReadBackExactly) {
  for (const std::string& name : scenario_names())
    for (const Size size : {Size::small, Size::full})
      for (const auto& p : make_scenario(name, size).mesh.points)
        for (const double x : {p.x, p.y, p.z})
          ASSERT_EQ(std::strtod(deck_number(x).c_str(), nullptr), x) << name;
}

TEST(Deck, ListsEachNodeHexahedronClampAndPressureOnce) {
  const Scenario scenario = make_scenario("s4_slab", Size::small);
  std::istringstream in(deck(scenario, Solver::direct));
  std::map<std::string, std::size_t> lines;
  std::string part;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('*'))
      part = line.substr(0, line.find(','));
    else
      ++lines[part];
  }
  EXPECT_EQ(lines["*NODE"], scenario.mesh.points.size());
  EXPECT_EQ(lines["*ELEMENT"], scenario.mesh.hexes.size());
  EXPECT_EQ(lines["*NSET"], lowest_points(scenario.mesh).size());
  EXPECT_EQ(lines["*DLOAD"], surface_pressures(scenario).size());
  EXPECT_EQ(lines["*ELASTIC"], scenario.materials.size());
}

TEST(Deck, NamesItsSolver) {
  const Scenario scenario = make_scenario("s3_three", Size::small);
  EXPECT_NE(deck(scenario, Solver::direct).find("SOLVER=SPOOLES\n"), std::string::npos);
  EXPECT_NE(deck(scenario, Solver::iterative).find("SOLVER=ITERATIVE SCALING\n"),
            std::string::npos);
}

}  // namespace
}  // namespace tensortopo::test
