// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/run_program.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/witness_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/sweep/sweep.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

SweepOptions options_of(const std::string& from, const std::string& to, std::size_t samples) {
  SweepOptions options;
  options.from = ModeValue::parse(from);
  options.to = ModeValue::parse(to);
  options.samples = samples;
  return options;
}

std::array<long, 3> topology(const SweepLevel& level) {
  return {static_cast<long>(level.components), level.euler_characteristic, level.boundary_loops};
}

std::array<long, 3> topology_at(const TetMesh& mesh, double mode) {
  const auto extraction =
      extract_mode_surface<double>(mesh, ModeValue::parse(std::to_string(mode)));
  EXPECT_TRUE(extraction.unresolved.empty()) << mode;
  const auto invariants = surface_invariants(extraction.surface);
  return {static_cast<long>(invariants.components), invariants.euler_characteristic,
          invariants.boundary_loops};
}

TetMesh noisy_cube(int n, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(n);
  fill_with_normal_tensors(mesh, seed);
  return mesh;
}

// Two computations that share nothing: links of critical points tell every change of the Euler
// characteristic, and levels between all of them are extracted.
TEST(Sweep, EventsAndLevelsAgree) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const TetMesh mesh = noisy_cube(1, seed);
    const Sweep sweep = sweep_modes(mesh, options_of("-0.95", "0.95", 5));
    EXPECT_GT(sweep.events.size(), 10u);
    ASSERT_EQ(sweep.intervals.size(), sweep.events.size() + 1);
    EXPECT_TRUE(sweep.contradictions.empty()) << seed;
    for (std::size_t i = 0; i < sweep.events.size(); ++i) {
      const auto &before = sweep.intervals[i], &after = sweep.intervals[i + 1];
      ASSERT_TRUE(before.level && after.level && sweep.events[i].euler_change());
      EXPECT_LT(before.low, before.high);
      const SweepLevel &below = sweep.levels[*before.level], &above = sweep.levels[*after.level];
      EXPECT_EQ(above.euler_characteristic - below.euler_characteristic,
                *sweep.events[i].euler_change());
      const auto growth = sweep.events[i].growth();
      ASSERT_TRUE(growth.has_value());
      EXPECT_LE((*growth)[0].least, topology(above)[0] - topology(below)[0]);
      EXPECT_GE((*growth)[0].most, topology(above)[0] - topology(below)[0]);
      EXPECT_LE((*growth)[1].least, above.boundary_loops - below.boundary_loops);
      EXPECT_GE((*growth)[1].most, above.boundary_loops - below.boundary_loops);
      // A single event does what its name says.
      if (sweep.events[i].points.size() > 1) continue;
      const long more = static_cast<long>(above.components) - static_cast<long>(below.components);
      const long loops = above.boundary_loops - below.boundary_loops;
      switch (sweep.events[i].points[0].effect.change) {
        case LocalChange::birth:
          EXPECT_EQ(more, 1);
          break;
        case LocalChange::death:
          EXPECT_EQ(more, -1);
          break;
        case LocalChange::join:
          EXPECT_TRUE(more == 0 || more == -1) << more;
          break;
        case LocalChange::split:
          EXPECT_GE(more, 0);
          break;
        case LocalChange::open:
          EXPECT_TRUE(more == 0 && loops == 1);
          break;
        case LocalChange::close:
          EXPECT_TRUE(more == 0 && loops == -1);
          break;
        default:
          ADD_FAILURE() << "not kept for nothing";
      }
    }
  }
}

// Nothing happens between events: levels at both ends of the widest intervals are alike.
TEST(Sweep, TopologyIsConstantBetweenEvents) {
  const TetMesh mesh = noisy_cube(2, 7);
  SweepOptions options = options_of("-0.9", "0.9", 3);
  options.most_levels = 0;
  Sweep sweep = sweep_modes(mesh, options);
  EXPECT_TRUE(sweep.contradictions.empty());
  std::sort(sweep.intervals.begin(), sweep.intervals.end(),
            [](const auto& a, const auto& b) { return a.high - a.low > b.high - b.low; });
  for (std::size_t i = 0; i < static_cast<std::size_t>(trials(6)); ++i) {
    const auto& [low, high, euler, level] = sweep.intervals[i];
    const double margin = (high - low) / 100;
    const auto at_low = topology_at(mesh, low + margin), at_high = topology_at(mesh, high - margin);
    EXPECT_EQ(at_low, at_high) << low << ' ' << high;
    ASSERT_TRUE(euler.has_value());
    EXPECT_EQ(at_low[1], *euler);
  }
}

// A saddle inside a tetrahedron, of mode -143/343: an annulus below becomes two discs.
TEST(Sweep, FindsTheSaddleOfATetrahedron) {
  const auto& witness = field_witness("saddle_origin_rational");
  const auto& points = witness.cases[0].points;
  const TetMesh mesh = single_tet_mesh(points, witness.field.at(points));
  const Sweep sweep = sweep_modes(mesh, options_of("-0.418", "-0.416", 2));
  ASSERT_EQ(sweep.events.size(), 1u);
  const auto& point = sweep.events[0].points.at(0);
  EXPECT_EQ(point.dimension, 3);
  EXPECT_LE(point.low, -143.0 / 343);
  EXPECT_GE(point.high, -143.0 / 343);
  EXPECT_EQ(topology(sweep.levels.front()), (std::array<long, 3>{2, 2, 2}));
  EXPECT_EQ(topology(sweep.levels.back()), (std::array<long, 3>{1, 0, 2}));
  EXPECT_EQ(*sweep.events[0].euler_change(), -2);
}

// Opposite tensors have opposite modes: the diagram is turned around.
TEST(Sweep, OfTheOppositeFieldIsTurnedAround) {
  const TetMesh mesh = noisy_cube(1, 11);
  TetMesh opposite = mesh;
  for (auto& t : opposite.tensors) t = -1.0 * t;
  const auto values = mesh_critical_values(mesh, -0.9, 0.9),
             others = mesh_critical_values(opposite, -0.9, 0.9);
  EXPECT_GT(values.points.size(), 10u);
  ASSERT_EQ(values.points.size(), others.points.size());
  EXPECT_EQ(values.looked_at, others.looked_at);
  for (std::size_t i = 0; i < values.points.size(); ++i) {
    const auto &a = values.points[i], &b = others.points[others.points.size() - 1 - i];
    EXPECT_LE(a.low, -b.low);
    EXPECT_GE(a.high, -b.high);
    EXPECT_EQ(a.effect.euler_change, -b.effect.euler_change);
  }
}

// The level at a mode is that of modes just above: a change at the last one belongs to it.
TEST(Sweep, MayEndAtACriticalValue) {
  int ends = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    TetMesh mesh = noisy_cube(1, seed);
    mesh.tensors[seed % mesh.tensors.size()] = {1, 0, -1, 0, 0, 0};  // of mode 0
    for (const auto& [from, to] : {std::pair("-1/2", "0"), std::pair("0", "1/2")}) {
      const Sweep sweep = sweep_modes(mesh, options_of(from, to, 3));
      EXPECT_TRUE(sweep.contradictions.empty()) << seed << ' ' << from << ' ' << to;
      ends += !sweep.events.empty() && sweep.events.back().high == 0;
    }
  }
  EXPECT_GT(ends, 2);
}

// Where there is no mode, and where it is constant, changes are undecided at worst.
TEST(Sweep, OfSpecialFieldsKeepsWhatItCannotDecide) {
  TetMesh mesh = noisy_cube(1, 5);
  mesh.tensors[0] = {};                     // no mode
  mesh.tensors[7] = 2.0 * mesh.tensors[6];  // constant along an edge
  SweepOptions options = options_of("-0.9", "0.9", 9);
  const Sweep sweep = sweep_modes(mesh, options);
  std::size_t undecided = 0;
  for (const auto& event : sweep.events) undecided += !event.euler_change();
  EXPECT_GT(undecided, 0u);
  EXPECT_TRUE(sweep.contradictions.empty());
}

// Without a level to start from nothing is known of the topology, and that is said.
TEST(Sweep, NeedsALevelToStartFrom) {
  SweepOptions options = options_of("-1", "1", 2);  // both are degenerate curves
  options.most_levels = 0;
  const Sweep sweep = sweep_modes(noisy_cube(1, 3), options);
  EXPECT_TRUE(sweep.levels.empty());
  EXPECT_GT(sweep.events.size(), 10u);
  for (const auto& interval : sweep.intervals) EXPECT_FALSE(interval.euler_characteristic);
}

RC_GTEST_PROP(Sweep, TakesModesInBetween, (const std::pair<int, int>& ends, int shift)) {
  RC_PRE(ends.first != ends.second);
  const double scale = std::ldexp(1.0, -32 - (shift & 7));
  const double low = std::min(ends.first, ends.second) * scale,
               high = std::max(ends.first, ends.second) * scale;
  const auto mode = mode_between(low, high);
  RC_ASSERT(mode.has_value());
  RC_ASSERT(low < mode->approx() && mode->approx() < high);
  RC_ASSERT(!mode_between(low, std::nextafter(low, 2.0)));
}

TEST(SweepProgram, WritesTheDiagramAsJsonAndAsAPicture) {
  const Folder folder;
  const std::string picture = folder / "sweep.png";
  const Outcome run =
      run_program({"analyze", field("s4_slab"), "--sweep", "0.55:0.65:3", "--json", "-o", picture});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("complete"), true);
  ASSERT_EQ(json.at("samples").size(), 3u);
  EXPECT_EQ(json.at("samples").at(1).at("mode_exact"), "3/5");
  ASSERT_EQ(json.at("intervals").size(), json.at("events").size() + 1);
  for (std::size_t i = 0; i < json.at("events").size(); ++i) {
    const Json& event = json.at("events").at(i);
    EXPECT_EQ(event.at("low"), json.at("intervals").at(i).at("high"));
    EXPECT_EQ(event.at("high"), json.at("intervals").at(i + 1).at("low"));
    EXPECT_FALSE(event.at("points").empty());
  }
  EXPECT_EQ(contents(picture).substr(1, 3), "PNG");
}

TEST(SweepProgram, SaysTheSameWhateverTheThreads) {
  std::vector<Json> said;
  for (const std::string threads : {"1", "3"}) {
    const Outcome run = run_program({"analyze", field("s3_three"), "--sweep", "0.1:0.15:2",
                                     "--levels", "0", "--threads", threads, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    said.push_back(Json::parse(run.out));
    said.back().erase("seconds");
    EXPECT_GT(said.back().at("events").size(), 10u);
  }
  EXPECT_EQ(said[0], said[1]);
}

// Degenerate curves run in planes of symmetry, but for rounding: rationals decide what happens
// there.
TEST(SweepProgram, LeavesNothingOpenOnPlanesOfSymmetry) {
  const Outcome sweep =
      run_program({"analyze", field("s3_three"), "--sweep=-1:1:2", "--levels", "0", "--json"});
  ASSERT_EQ(sweep.status, 0) << sweep.err;
  const Json changes = Json::parse(sweep.out).at("changes");
  EXPECT_FALSE(changes.contains("undecided")) << changes;
  const Outcome persistence =
      run_program({"analyze", field("s3_three"), "--persistence", "--json"});
  ASSERT_EQ(persistence.status, 0) << persistence.err;
  const Json pairs = Json::parse(persistence.out).at("pairs");
  EXPECT_GT(pairs.size(), 700u);
  const auto certain = std::count_if(pairs.begin(), pairs.end(),
                                     [](const Json& pair) { return pair.at("certain") == true; });
  EXPECT_GT(certain, 660);
}

TEST(SweepProgram, SaysThatAnIsotropicFieldHasNoMode) {
  const Folder folder;
  const std::string file = folder / "isotropic.vtk";
  std::ofstream(file) << "# vtk DataFile Version 3.0\nisotropic\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                         "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\n"
                         "CELL_TYPES 1\n10\nPOINT_DATA 4\nTENSORS s double\n"
                         "1 0 0 0 1 0 0 0 1\n2 0 0 0 2 0 0 0 2\n3 0 0 0 3 0 0 0 3\n"
                         "1 0 0 0 1 0 0 0 1\n";
  for (const std::vector<std::string>& what :
       {std::vector<std::string>{"--sweep", "0:0.5:3"}, {"--persistence"}, {"--graph"}}) {
    std::vector<std::string> words{"analyze", file};
    words.insert(words.end(), what.begin(), what.end());
    const Outcome run = run_program(words);
    EXPECT_NE((run.out + run.err).find("undefined everywhere"), std::string::npos)
        << run.out << run.err;
  }
}

TEST(SweepProgram, RefusesWhatMakesNoSense) {
  for (const std::string sweep : {"0.1:0.2", "0.2:0.1:5", "0:1:1", "0:2:5", "a:b:c", "0:1:5x"}) {
    const Outcome run = run_program({"analyze", field("s4_slab"), "--sweep", sweep});
    EXPECT_EQ(run.status, 2) << sweep;
    EXPECT_NE(run.err.find("--sweep"), std::string::npos) << run.err;
  }
  EXPECT_EQ(run_program({"analyze", "nowhere.vtu", "--sweep", "0:0.1:2"}).status, 3);
}

}  // namespace
}  // namespace tensortopo::test
