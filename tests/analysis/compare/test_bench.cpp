// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/run_program.hpp"
#include "bench/level_distance.hpp"
#include "bench/time_budget.hpp"
#include "bench/timing.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

TEST(Bench, ReportsMediansAndTheirRatios) {
  const Outcome run = run_program(
      {"bench", "--input", field("s4_slab"), "--mode", "0.5", "--threads", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("modes"), Json::array({0.5}));
  EXPECT_EQ(json.at("threads"), 1);
  EXPECT_GT(json.at("peak_memory_bytes"), 1000000);
  const double ours = json.at("times").at("extract");
  for (const std::string name : {"vtk_contour", "vtk_contour_3d_linear_grid"}) {
    const double theirs = json.at("times").at(name);
    EXPECT_GT(theirs, 0);
    EXPECT_DOUBLE_EQ(json.at("ratios").at("extract_over_" + name).get<double>(), ours / theirs);
    EXPECT_EQ(json.at("all_times").at(name).size(), 5u);
    EXPECT_GT(json.at("triangles").at(name), 100);
  }
}

/// A field of a few tetrahedra.
std::string small_field() {
  const auto folder = std::filesystem::path(testing::TempDir()) / "bench";
  std::filesystem::create_directories(folder);
  const std::string file = folder / "small.vtu";
  EXPECT_EQ(run_program({"generate", "complex", "--seed", "3", "--field-only", "-o", file}).status,
            0);
  return file;
}

TEST(Bench, APlainRunHasTheKeysOfTheContractAndSaysWhyARatioIsMissing) {
  const Outcome run = run_program({"bench", "--input", small_field(), "--mode", "1/2", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  for (const char* key :
       {"input", "modes", "threads", "times", "ratios", "peak_memory_bytes", "errors", "notes"})
    EXPECT_TRUE(json.contains(key)) << key;
  const Json& ratios = json.at("ratios");
  EXPECT_GT(ratios.at("certified_over_vtk_contour"), 0);
  for (const char* name :
       {"a_patches_over_extract", "hybrid_over_neutral", "vtk_subdivided_over_extract"}) {
    EXPECT_TRUE(ratios.at(name).is_null()) << name;
    EXPECT_FALSE(json.at("notes").at(name).get<std::string>().empty());
  }
}

TEST(Bench, AllComparisonsAreMadeAtAnErrorOfOursThatIsNoLarger) {
  const Outcome run =
      run_program({"bench", "--input", small_field(), "--mode", "1/2", "--all", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  const Json& times = json.at("times");
  const auto quotient = [&](const char* over, const char* under) {
    return times.at(over).get<double>() / times.at(under).get<double>();
  };
  const Json& ratios = json.at("ratios");
  EXPECT_DOUBLE_EQ(ratios.at("a_patches_over_extract"),
                   quotient("a_patches", "extract_for_a_patches"));
  EXPECT_DOUBLE_EQ(ratios.at("vtk_subdivided_over_extract"), quotient("vtk_subdivided", "extract"));
  const Json& errors = json.at("errors");
  const auto distance = [&](const char* method) {
    return errors.at(method).at("distance").at("root_mean_square").get<double>();
  };
  EXPECT_LE(distance("vtk_subdivided"), distance("extract"));
  EXPECT_GT(distance("vtk_contour"), 2 * distance("extract"));
  EXPECT_LE(distance("reference"), distance("extract"));
  // Ours has the certified topology by construction; contouring the vertices sees less of it.
  const Json& ours = errors.at("extract").at("topology");
  EXPECT_EQ(ours.at("components"), ours.at("true_components"));
  EXPECT_EQ(ours.at("euler_characteristic"), ours.at("true_euler_characteristic"));
  EXPECT_EQ(ours.at("missed_crossings"), 0);
  EXPECT_GT(errors.at("vtk_contour").at("topology").at("missed_crossings"), 0);
  EXPECT_GT(errors.at("hybrid").at("triangles"), 100);
}

TEST(Bench, NegativeModesArePrintedOnceAndWithoutASecondSign) {
  const Outcome run = run_program({"bench", "--input", small_field(), "--mode", "-1/2", "--mode",
                                   "1/2", "--mode", "0", "--only", "none"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("modes +-1/2 0,"), std::string::npos) << run.out;
}

TEST(Bench, CurvesHaveOnePointForEachSettingAndAPicture) {
  const std::string field = small_field(), picture = field + ".png";
  const Outcome run = run_program(
      {"bench", "--input", field, "--mode", "0", "--only", "none", "--curves", picture, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(std::filesystem::file_size(picture), 5000u);
  const Json curves = Json::parse(run.out).at("curves");
  for (const auto& [method, points] : curves.items()) {
    EXPECT_GE(points.size(), 4u) << method;
    EXPECT_LT(points.back().at("root_mean_square").get<double>(),
              points.front().at("root_mean_square").get<double>())
        << method;
  }
}

TEST(Bench, ScalingTimesEachPointAndFitsAPower) {
  const std::string picture = small_field() + ".scaling.png";
  const Outcome run = run_program(
      {"bench", "--scaling", "modes", "--input", small_field(), "--chart", picture, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(std::filesystem::file_size(picture), 5000u);
  const Json json = Json::parse(run.out);
  std::vector<double> x, y;
  for (const Json& point : json.at("points")) {
    x.push_back(point.at("modes"));
    y.push_back(point.at("extract"));
  }
  EXPECT_EQ(x, (std::vector<double>{1, 2, 4, 8, 16}));
  EXPECT_DOUBLE_EQ(json.at("exponent"), power_law_exponent(x, y));
  EXPECT_EQ(run_program({"bench", "--scaling", "size", "--mode", "0", "--largest", "10"}).status,
            2);
}

TEST(Bench, TheSerialShareIsWhatMoreThreadsDoNotShorten) {
  std::vector<double> threads{1, 2, 4, 64}, seconds;
  for (const double n : threads) seconds.push_back(7 * (0.03 + 0.97 / n));
  EXPECT_NEAR(serial_share(threads, seconds), 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(serial_share({1}, {7})));
}

TEST(Bench, ThePowerOfALawIsItsExponent) {
  std::vector<double> x, y;
  for (const double t : {10.0, 200.0, 3000.0, 50000.0}) {
    x.push_back(t);
    y.push_back(7e-6 * std::pow(t, 1.25));
  }
  EXPECT_NEAR(power_law_exponent(x, y), 1.25, 1e-12);
  EXPECT_TRUE(std::isnan(power_law_exponent({3}, {4})));
}

TEST(Bench, ContendersTakeTurns) {
  std::string order;
  const auto log = [&](char c) {
    return [&order, c] {
      order += c;
      return static_cast<std::size_t>(c);
    };
  };
  const auto series = time_in_turn({{"a", log('a')}, {"b", log('b')}}, 5);
  EXPECT_EQ(order, "ababababab");
  EXPECT_EQ(series[1].seconds.size(), 5u);
  EXPECT_EQ(series[1].triangles, static_cast<std::size_t>('b'));
}

TEST(Bench, WithoutTimeLeftContendersRunOnce) {
  int runs = 0;
  const auto run = [&runs] { return static_cast<std::size_t>(++runs); };
  EXPECT_EQ(time_in_turn({{"a", run}}, 5, {}, 0)[0].seconds.size(), 1u);
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(time_in_turn({{"a", run}}, 5, {}, 1e9)[0].seconds.size(), 5u);
}

TEST(Bench, ABudgetIsDividedByWeightsAndNeverNegative) {
  TimeBudget budget(1e6, 10);
  EXPECT_NEAR(budget.take(1), 1e5, 10);
  EXPECT_NEAR(budget.take(3), 1e6 / 3, 40);  // of nine parts that are left
  EXPECT_NEAR(budget.take(6), 1e6, 10);      // the last one may take all that is left
  EXPECT_EQ(TimeBudget(0, 1).take(1), 0);
}

// Along x the tensors go from diag(1, 0, -1) with mode 0 to both sides: the neutral surface is the
// plane x = 1/2, and its copy at a distance d away is d from it, both ways.
TEST(Bench, TheDistanceOfAShiftedPlaneIsTheShift) {
  TetMesh mesh = test::cube_mesh(1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const double t = mesh.points[i].x - 0.5;
    mesh.tensors[i] = {1, 2 * t, -1, 0, 0, 0};
  }
  ExtractOptions options;
  const auto surface = extract_mode_surface<double>(mesh, ModeValue(), options).surface;
  ASSERT_GT(surface.triangles.size(), 0u);
  const auto none = level_distance(mesh, surface, mesh, surface, ModeValue());
  EXPECT_LT(none.largest(), 1e-9);
  const double shift = 1e-3;
  SurfaceMesh moved = surface;
  for (auto& p : moved.points) p.x += shift;
  const auto off = level_distance(mesh, moved, mesh, surface, ModeValue());
  EXPECT_NEAR(off.to_level.root_mean_square(), shift, 1e-5);
  EXPECT_NEAR(off.from_level.root_mean_square(), shift, 1e-5);
  // Half of it is missing: seen from the level only.
  SurfaceMesh half = surface;
  half.triangles.resize(surface.triangles.size() / 2);
  half.tet.resize(half.triangles.size());
  const auto partial = level_distance(mesh, half, mesh, surface, ModeValue());
  EXPECT_LT(partial.to_level.largest, 1e-9);
  EXPECT_GT(partial.from_level.largest, 0.05);
  EXPECT_TRUE(std::isinf(level_distance(mesh, {}, mesh, surface, ModeValue()).largest()));
}

TEST(Bench, FewerThanFiveTimingsAreRefused) {
  EXPECT_EQ(
      run_program({"bench", "--input", field("s4_slab"), "--mode", "0.5", "--repeat", "4"}).status,
      2);
}

TEST(Bench, AReportHasARowForEachFieldAndModeAndSaysWhatItIsOf) {
  const Folder folder;
  const std::string g = folder / "g.vtu", page = folder / "m.md";
  ASSERT_EQ(run_program({"generate", "linear", "-o", g, "--field-only"}).status, 0);
  const Outcome run =
      run_program({"bench", "--report", page, "--input", g, "--mode", "-1/10", "--mode", "0"});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string text = contents(page);
  for (const char* part :
       {"# Measurements", "| machine | ", "| commit | ", "| date | 20",
        "| `tests/run --all` passed last | ", "| load at the start | ", "| g | 1 | ±1/10 | ",
        "| g | 1 | 0 | ", "## Programs", "## Degenerate curves", "## Next to modes 1 and -1"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  // Every row of a table has as many columns as its head.
  std::istringstream lines(text);
  std::ptrdiff_t columns = 0;
  int rows = 0;
  for (std::string line; std::getline(lines, line); ++rows) {
    if (line.empty() || line.front() != '|') {
      columns = 0;
      continue;
    }
    const auto count = std::count(line.begin(), line.end(), '|');
    if (columns == 0) columns = count;
    EXPECT_EQ(count, columns) << line;
  }
  EXPECT_GT(rows, 20);
}

}  // namespace
}  // namespace tensortopo::test
