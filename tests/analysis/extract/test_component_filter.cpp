// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What extractions leave out when asked to: small components, and cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "support/compared.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

Json report_of(std::vector<std::string> words) {
  words.push_back("--json");
  const Outcome run = run_program(words);
  EXPECT_EQ(run.status, 0) << run.err;
  return Json::parse(run.out, nullptr, false);
}

std::vector<double> areas(const Json& surface) {
  std::vector<double> result;
  for (const Json& part : surface.at("parts")) result.push_back(part.at("area"));
  return result;
}

TEST(ComponentFilter, LeavesOutSurfacesOfLessArea) {
  const Folder folder;
  std::vector<std::string> words{"extract",        field("s3_three"), "-o",
                                 folder / "s.vtp", "--mode",          "0.9"};
  const std::vector<double> all = areas(report_of(words).at("surfaces").at(0));
  Compared compared("components on both sides of the limit", 2);
  std::vector<double> sorted = all;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_GT(sorted.size(), 1u);
  const double least = sorted[sorted.size() / 2];
  std::vector<double> kept;
  for (const double area : all)
    if (area >= least) kept.push_back(area);
  compared.count(!kept.empty());
  compared.count(kept.size() < all.size());
  words.insert(words.end(), {"--min-area", Json(least).dump()});
  const Json surface = report_of(words).at("surfaces").at(0);
  EXPECT_EQ(areas(surface), kept);
  const Json& filter = surface.at("filter");
  EXPECT_EQ(filter.at("min_area"), least);
  EXPECT_EQ(filter.at("left_out_small"), all.size() - kept.size());
  EXPECT_LT(filter.at("largest_left_out_small"), least);
  EXPECT_FALSE(filter.contains("min_persistence"));
  words.pop_back(), words.push_back("1e300");
  EXPECT_EQ(report_of(words).at("surfaces").at(0).at("triangles"), 0);
}

TEST(ComponentFilter, LeavesOutCurvesOfLessLength) {
  const Folder folder;
  std::vector<std::string> words{"extract",        field("s3_three"), "-o",
                                 folder / "c.vtp", "--mode",          "1"};
  const Json all = report_of(words).at("curves").at(0);
  const double length = all.at("length");
  const int components = all.at("components");
  ASSERT_GT(components, 1);
  // Not all have the mean length, or all have.
  words.insert(words.end(), {"--min-length", Json(length / components).dump()});
  const Json some = report_of(words).at("curves").at(0);
  const int left_out = some.at("filter").at("left_out_small");
  EXPECT_EQ(some.at("components"), components - left_out);
  EXPECT_LE(some.at("length"), length);
  EXPECT_GT(some.at("components"), 0);
  EXPECT_LE(some.at("filter").at("largest_left_out_small"), length / components);
  words.back() = Json(2 * length).dump();
  EXPECT_EQ(report_of(words).at("curves").at(0).at("filter").at("left_out_small"), components);
}

TEST(ComponentFilter, IsRefusedWhereItHasNoEffectOrAllMustStay) {
  const Folder folder;
  const std::vector<std::string> begin{"extract", field("s4_slab"), "-o", folder / "s.vtp"};
  const auto refused = [&](std::vector<std::string> more, const std::string& what) {
    more.insert(more.begin(), begin.begin(), begin.end());
    const Outcome run = run_program(more);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
  };
  refused({"--mode", "0.5", "--min-area", "1", "--certify", folder / "c.json"}, "--min-area");
  refused({"--mode", "0.5", "--min-length", "1"}, "--min-length");
  refused({"--mode", "1", "--min-area", "1"}, "--min-length");
  refused({"--mode", "0.5", "--min-area", "-1"}, "--min-area");
  refused({"--mode", "0.5", "--where", "z > 1", "--certify", folder / "c.json"}, "--where");
}

TEST(CellsLeftOut, AreCountedAndTheRestIsAFieldOfItsOwn) {
  const Folder folder;
  const std::string where = "mode > -0.2";
  const Json all =
      report_of({"extract", field("s4_slab"), "-o", folder / "all.vtp", "--mode", "0.5"});
  const Json part = report_of(
      {"extract", field("s4_slab"), "-o", folder / "part.vtp", "--mode", "0.5", "--where", where});
  const Json& input = part.at("input");
  const int tets = input.at("tetrahedra"), left_out = input.at("cells_left_out");
  EXPECT_GT(tets, 0);
  EXPECT_GT(left_out, 0);
  EXPECT_EQ(tets + left_out, all.at("input").at("tetrahedra"));
  EXPECT_EQ(all.at("input").at("cells_left_out"), 0);
  EXPECT_LE(part.at("surfaces").at(0).at("area"), all.at("surfaces").at(0).at("area"));
  // As a file of its own it can be certified.
  EXPECT_EQ(run_program({"convert", field("s4_slab"), "--where", where, "-o", folder / "part.vtu"})
                .status,
            0);
  const Json again = report_of({"extract", folder / "part.vtu", "-o", folder / "again.vtp",
                                "--mode", "0.5", "--certify", folder / "again.json"});
  EXPECT_EQ(again.at("input").at("tetrahedra"), tets);
  EXPECT_EQ(again.at("surfaces").at(0).at("parts"), part.at("surfaces").at(0).at("parts"));
}

}  // namespace
}  // namespace tensortopo::test
