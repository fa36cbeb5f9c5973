// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/run_program.hpp"
#include "tensortopo/analysis/extract_report.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

// One extraction that the tests share: two modes in one file.
struct Shared {
  Folder folder;
  Outcome run = run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode", "0.5",
                             "--mode", "-1/2", "--json"});
  Json json = Json::parse(run.out, nullptr, false);
};

const Shared& shared() {
  static const Shared once;
  return once;
}

TEST(ExtractReport, IsOneJsonObjectAndNothingElse) {
  EXPECT_EQ(shared().run.status, 0);
  EXPECT_TRUE(shared().json.is_object()) << shared().run.out.substr(0, 300);
}

TEST(ExtractReport, IsSilentOnStandardErrorInAPipe) { EXPECT_EQ(shared().run.err, ""); }

TEST(ExtractReport, DescribesTheInput) {
  const Json& input = shared().json.at("input");
  EXPECT_EQ(input.at("path"), field("s4_slab"));
  EXPECT_EQ(input.at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(input.at("vertices"), 1665);
  EXPECT_EQ(input.at("tetrahedra"), 7488);
}

TEST(ExtractReport, HasEveryKeyOfTheContract) {
  for (const char* key : {"curves", "unresolved", "unresolved_cells", "statistics"}) {
    EXPECT_TRUE(shared().json.contains(key)) << key;
  }
  for (const char* key : {"read", "edges", "faces", "tets", "stitch", "certify", "write"}) {
    EXPECT_TRUE(shared().json.at("seconds").at(key).is_number()) << key;
  }
  for (const Json& surface : shared().json.at("surfaces")) {
    for (const char* key : {"mode", "mode_exact", "vertices", "triangles", "components",
                            "boundary_loops", "euler_characteristic", "orientable", "closed",
                            "manifold", "area", "max_abs_residual", "tets_crossed", "parts"}) {
      EXPECT_TRUE(surface.contains(key)) << key;
    }
    for (const Json& part : surface.at("parts")) {
      for (const char* key :
           {"euler_characteristic", "boundary_loops", "genus", "triangles", "area"}) {
        EXPECT_TRUE(part.contains(key)) << key;
      }
    }
  }
}

TEST(ExtractReport, KeepsTheOrderAndTheExactModes) {
  const Json& surfaces = shared().json.at("surfaces");
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].at("mode"), 0.5);
  EXPECT_EQ(surfaces[0].at("mode_exact"), "1/2");
  EXPECT_EQ(surfaces[1].at("mode"), -0.5);
  EXPECT_EQ(surfaces[1].at("mode_exact"), "-1/2");
}

// Surfaces and curves in one file.
struct Mixed {
  Folder folder;
  Outcome run = run_program({"extract", field("s1_compress_off"), "-o", folder / "m.vtp", "--mode",
                             "-1", "--mode", "0.9", "--mode", "1.0", "--json"});
  Json json = Json::parse(run.out, nullptr, false);
};

TEST(ExtractReport, ListsCurvesApartFromSurfaces) {
  const Mixed mixed;
  ASSERT_EQ(mixed.run.status, 0) << mixed.run.err;
  ASSERT_EQ(mixed.json.at("surfaces").size(), 1u);
  const Json& curves = mixed.json.at("curves");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].at("mode"), -1);
  EXPECT_EQ(curves[1].at("mode"), 1);
  EXPECT_EQ(curves[1].at("mode_exact"), "1");
  for (const Json& curve : curves) {
    EXPECT_GT(curve.at("vertices").get<int>(), 100);
    EXPECT_GT(curve.at("length").get<double>(), 0);
    EXPECT_GT(curve.at("components").get<int>(), curve.at("closed_components").get<int>());
    EXPECT_LT(curve.at("max_residual").get<double>(), 1e-9);
    EXPECT_TRUE(curve.at("unresolved").empty());
  }
  EXPECT_TRUE(mixed.json.at("unresolved_cells").empty());
}

TEST(ExtractReport, TextHasARowForEachCurve) {
  const Folder folder;
  const Outcome run = run_program({"extract", field("s1_compress_off"), "-o", folder / "c.obj",
                                   "--mode", "1", "--generalized"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("curves"), std::string::npos);
  EXPECT_NE(run.out.find("\n        -1 "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("triangles"), std::string::npos);
}

TEST(ExtractReport, PartsAddUpToTheWhole) {
  for (const Json& surface : shared().json.at("surfaces")) {
    long euler = 0, loops = 0, triangles = 0;
    double area = 0;
    for (const Json& part : surface.at("parts")) {
      euler += part.at("euler_characteristic").get<long>();
      loops += part.at("boundary_loops").get<long>();
      triangles += part.at("triangles").get<long>();
      area += part.at("area").get<double>();
    }
    EXPECT_EQ(surface.at("parts").size(), surface.at("components"));
    EXPECT_EQ(euler, surface.at("euler_characteristic"));
    EXPECT_EQ(loops, surface.at("boundary_loops"));
    EXPECT_EQ(triangles, surface.at("triangles"));
    EXPECT_NEAR(area, surface.at("area").get<double>(), 1e-9 * area);
  }
}

TEST(ExtractReport, ModeSurfacesAreOrientableManifolds) {
  for (const Json& surface : shared().json.at("surfaces")) {
    EXPECT_TRUE(surface.at("manifold").get<bool>());
    EXPECT_TRUE(surface.at("orientable").get<bool>());
    EXPECT_GT(surface.at("triangles"), 100);
  }
}

TEST(ExtractReport, GeneralizedEqualsBothModes) {
  const Folder folder;
  const Outcome run = run_program({"extract", field("s4_slab"), "-o", folder / "g.vtp", "--mode",
                                   ".5", "--generalized", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contents(folder / "g.vtp") == contents(shared().folder / "s.vtp"));
  EXPECT_EQ(Json::parse(run.out).at("surfaces"), shared().json.at("surfaces"));
}

TEST(ExtractReport, RepeatedModesCountOnce) {
  const Folder folder;
  const Outcome run =
      run_program({"extract", field("s4_slab"), "-o", folder / "g.vtp", "--mode", "0.5", "--mode",
                   "5/10", "--mode", "-0.50", "--generalized", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out).at("surfaces").size(), 2u);
}

TEST(ExtractReport, HasOneNeutralSurfaceWithTheGeneralizedOptionToo) {
  const Folder folder;
  const Outcome run = run_program({"extract", field("s4_slab"), "-o", folder / "n.vtp", "--mode",
                                   "0", "--generalized", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json surfaces = Json::parse(run.out).at("surfaces");
  ASSERT_EQ(surfaces.size(), 1u);
  EXPECT_EQ(surfaces.at(0).at("mode"), 0.0);
  EXPECT_GT(surfaces.at(0).at("triangles"), 0);
  EXPECT_TRUE(surfaces.at(0).at("manifold"));
  EXPECT_TRUE(surfaces.at(0).at("orientable"));
  EXPECT_TRUE(surfaces.at(0).at("unresolved").empty());
}

TEST(ExtractReport, WithoutJsonIsATableForPeople) {
  const Folder folder;
  const Outcome run = run_program({"extract", field("s4_slab"), "-o", folder / "s.stl", "--mode",
                                   "-9/10", "--resolution", "3"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("-9/10"), std::string::npos);
  EXPECT_NE(run.out.find("s.stl"), std::string::npos);
  EXPECT_FALSE(Json::accept(run.out));
}

/// The exact fraction has hundreds of digits, which JSON keeps.
TEST(ExtractReport, ALongFractionIsShownAsTheShortestDecimal) {
  const Folder folder;
  for (const auto& [asked, shown] : std::vector<std::pair<std::string, std::string>>{
           {"1e-300", "    1e-300"}, {"-0.1234567890123456789", "-0.12345678901234568"}}) {
    std::vector<std::string> words{"extract", field("s4_slab"), "-o",     folder / "s.vtp",
                                   "--mode",  asked,            "--mode", "1/2"};
    const Outcome text = run_program(words);
    ASSERT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("\n" + shown + " "), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("\n       1/2 "), std::string::npos) << text.out;
    words.push_back("--json");
    const Json surface = Json::parse(run_program(words).out).at("surfaces").at(0);
    EXPECT_EQ(surface.at("mode"), std::stod(asked));
    EXPECT_EQ(surface.at("mode_exact"), asked == "1e-300"
                                            ? "1/1" + std::string(300, '0')
                                            : "-1234567890123456789/1" + std::string(19, '0'));
  }
}

// One edge has xz and yz components alone, and so mode 0.
std::string mesh_with_a_neutral_edge(const Folder& folder) {
  const std::string file = folder / "edge.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
one edge of constant mode
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 double
0 0 0  1 0 0  0 1 0  0 0 1
CELLS 1 5
4 0 1 2 3
CELL_TYPES 1
10
POINT_DATA 4
TENSORS6 stress double
0 0 0 0 0 1
0 0 0 0 1 0
3 -1 -2 0.5 0 0.25
-2 1 1 0.5 0.25 0
)";
  return file;
}

TEST(ExtractReport, SaysWhatToAskForWhereTheModeIsConstant) {
  const Folder folder;
  const auto run = [&](const std::string& mode, bool quiet) {
    std::vector<std::string> words{
        "extract", mesh_with_a_neutral_edge(folder), "-o", folder / "s.vtp", "--mode", mode};
    if (quiet) words.push_back("--quiet");
    return run_program(words).err;
  };
  const std::string line = "tensortopo: " + (folder / "edge.vtk") +
                           ": 1 of 1 tetrahedron unresolved (1 level_constant_on_edge)";
  EXPECT_EQ(run("0", false), line +
                                 "; where the level is constant, ask for a mode next to it, for example --mode 1e-9, which "
                                 "holds the surface beside those edges and faces\n");
  EXPECT_EQ(run("0", true), line + "\n");
  EXPECT_EQ(run("1e-9", false).find("unresolved"), std::string::npos);
}

TEST(ExtractReport, AsksForModesThatDifferLittleAndAreModes) {
  for (const char* text :
       {"0", "1/2", "-9/10", "143/343", "1e-12", "0.9999999999", "-0.9999999999"}) {
    const ModeValue mode = ModeValue::parse(text);
    ExtractReport report;
    report.unresolved = {{3, "zero_deviator_inside", {mode}}};
    EXPECT_EQ(unresolved_advice(report), "");
    report.unresolved.push_back({3, "level_constant_on_face", {mode}});
    const std::string advice = unresolved_advice(report);
    const auto begin = advice.find("--mode ") + 7;
    const ModeValue beside =
        ModeValue::parse(advice.substr(begin, advice.find(',', begin) - begin));
    EXPECT_GT(std::abs(beside.approx() - mode.approx()), 0.9e-9) << advice;
    EXPECT_LT(std::abs(beside.approx() - mode.approx()), 1.1e-9) << advice;
    EXPECT_LT(std::abs(beside.approx()), 1) << advice;
  }
}

}  // namespace
}  // namespace tensortopo::test
