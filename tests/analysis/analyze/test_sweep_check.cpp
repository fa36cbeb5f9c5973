// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analyze/sweep/sweep_check.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

MeshCriticalPoint critical_point(double mode, LocalEffect effect) {
  MeshCriticalPoint point;
  point.low = std::nextafter(mode, -1.0);
  point.high = std::nextafter(mode, 1.0);
  point.effect = effect;
  return point;
}

constexpr LocalEffect kBirth{LocalChange::birth, 2, false, {1, 1}, {0, 0}};
constexpr LocalEffect kOpen{LocalChange::open, -1, true, {0, 0}, {1, 1}};

/// From no surface to a sphere at 0.25, and on to a sphere with a hole at 0.5.
Sweep sphere_then_disc() {
  Sweep sweep;
  for (const auto& [mode, effect] : {std::pair{0.25, kBirth}, {0.5, kOpen}}) {
    const MeshCriticalPoint point = critical_point(mode, effect);
    sweep.events.push_back({point.low, point.high, {point}});
  }
  sweep.intervals = {{0, sweep.events[0].low, 0, {}},
                     {sweep.events[0].high, sweep.events[1].low, 2, {}},
                     {sweep.events[1].high, 1, 1, {}}};
  return sweep;
}

CheckedLevel level(std::size_t interval, const std::string& mode, std::size_t components,
                   long euler_characteristic, long boundary_loops) {
  return {interval,
          {ModeValue::parse(mode), components, euler_characteristic, boundary_loops, 0, 0}};
}

SweepCheck true_levels() {
  SweepCheck check;
  check.levels = {level(0, "1/8", 0, 0, 0), level(0, "1/5", 0, 0, 0), level(1, "0.3", 1, 2, 0),
                  level(1, "0.4", 1, 2, 0), level(2, "0.6", 1, 1, 1)};
  return check;
}

TEST(SweepCheck, TriesTheMiddlesAndBesideEachCriticalValue) {
  const Sweep sweep = sphere_then_disc();
  const ModesToCheck all = modes_to_check(sweep, 100);
  EXPECT_EQ(all.events, 2u);
  EXPECT_TRUE(all.none.empty());
  ASSERT_EQ(all.modes.size(), 7u);  // the middle between the two is wanted twice
  for (std::size_t i = 0; i < all.modes.size(); ++i) {
    const double mode = all.modes[i].mode.approx();
    const SweepInterval& interval = sweep.intervals[all.modes[i].interval];
    EXPECT_TRUE(interval.low < mode && mode < interval.high);
    EXPECT_TRUE(i == 0 || all.modes[i - 1].mode.approx() < mode);
    // Middles and neighbours in turn: middle, beside 0.25, beside it, middle, ...
    const double share = (mode - interval.low) / (interval.high - interval.low);
    const double nearest = std::min(share, 1 - share);
    EXPECT_TRUE(i % 3 == 0 ? nearest > 0.25 : nearest < 0.0021) << i << ' ' << mode;
  }
  for (const std::size_t few : {1u, 3u, 4u}) EXPECT_EQ(modes_to_check(sweep, few).events, 1u);
  Sweep without = sweep;
  without.events.clear();
  without.intervals.resize(1);
  EXPECT_EQ(modes_to_check(without, 1).modes.size(), 1u);
  EXPECT_EQ(modes_to_check(sweep, 4).modes.size(), 4u);
}

TEST(SweepCheck, NamesRangesWithoutAMode) {
  Sweep sweep = sphere_then_disc();
  sweep.intervals[1].low = std::nextafter(sweep.intervals[1].high, 0.0);
  EXPECT_EQ(modes_to_check(sweep, 100).modes.size(), 4u);
  EXPECT_EQ(modes_to_check(sweep, 100).none.size(), 3u);
}

TEST(SweepCheck, AgreesWithWhatIsTrue) {
  SweepCheck check = true_levels();
  compare_levels(sphere_then_disc(), check);
  EXPECT_TRUE(check.contradictions.empty());
  EXPECT_TRUE(check.undecided.empty());
  EXPECT_EQ(check.compared, 2u);
}

// One number changed in one level is found, be it components, Euler characteristic or loops.
TEST(SweepCheck, FindsEachForgery) {
  for (std::size_t i = 0; i < true_levels().levels.size(); ++i) {
    for (int what = 0; what < 3; ++what) {
      SweepCheck check = true_levels();
      SweepLevel& forged = check.levels[i].level;
      if (what == 0) ++forged.components;
      if (what == 1) forged.euler_characteristic -= 2;
      if (what == 2) ++forged.boundary_loops;
      compare_levels(sphere_then_disc(), check);
      EXPECT_FALSE(check.contradictions.empty()) << i << ' ' << what;
    }
  }
}

TEST(SweepCheck, SaysWhatItCannotCompare) {
  Sweep sweep = sphere_then_disc();
  sweep.events[1].points[0].effect = {};  // undecided
  sweep.intervals[2].euler_characteristic.reset();
  SweepCheck check = true_levels();
  check.levels[0].level.unresolved = 1;
  compare_levels(sweep, check);
  EXPECT_TRUE(check.contradictions.empty());
  EXPECT_EQ(check.undecided.size(), 3u);
  EXPECT_EQ(check.compared, 1u);
}

// On a real field: surfaces around critical values, each certified by the independent checker, are
// what the diagram says.
TEST(SweepProgram, AgreesWithCertifiedSurfaces) {
  const Outcome run = run_program({"analyze", field("s4_slab"), "--sweep", "-0.8:0.8:3", "--levels",
                                   "0", "--check", "12", "--json"});
  if (run.err.find("built without") != std::string::npos) GTEST_SKIP() << run.err;
  ASSERT_EQ(run.status, 0) << run.err << run.out;
  const Json check = Json::parse(run.out).at("check");
  EXPECT_EQ(check.at("levels").size(), 12u);
  EXPECT_EQ(check.at("critical_values_compared"), 3);
  EXPECT_GT(check.at("certified"), 10000);
  EXPECT_TRUE(check.at("contradictions").empty());
  EXPECT_TRUE(check.at("undecided").empty());
}

TEST(SweepProgram, ChecksSweepsOnly) {
  EXPECT_EQ(run_program({"analyze", "surface.vtp", "--check", "4"}).status, 2);
}

}  // namespace
}  // namespace tensortopo::test
