// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "analysis/run_program.hpp"
#include "analyze/surface/surface_quality.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

TEST(TriangleQuality, OfKnownTriangles) {
  const auto equilateral = quality_of({{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}});
  EXPECT_NEAR(equilateral[0], 60, 1e-12);
  EXPECT_NEAR(equilateral[1], 1, 1e-12);
  // Right and isosceles: circumradius sqrt(2) / 2, inradius 1 - sqrt(2) / 2.
  const auto right = quality_of({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}});
  EXPECT_NEAR(right[0], 45, 1e-12);
  EXPECT_NEAR(right[1], std::sqrt(0.5) / (2 - std::sqrt(2)), 1e-12);
  const auto flat = quality_of({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}});
  EXPECT_EQ(flat[0], 0);
  EXPECT_TRUE(std::isinf(flat[1]));
}

RC_GTEST_PROP(TriangleQuality, DoesNotDependOnSizeOrOrder, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const Vector3<double> p{number(), number(), number()}, q{number(), number(), number()},
      r{number(), number(), number()};
  const auto one = quality_of({p, q, r}), other = quality_of({8.0 * r, 8.0 * p, 8.0 * q});
  RC_PRE(one[0] > 1e-3);
  RC_ASSERT(std::abs(one[0] - other[0]) < 1e-6 && std::abs(one[1] / other[1] - 1) < 1e-6);
  RC_ASSERT(one[0] <= 60 + 1e-9 && one[1] >= 1);
}

SurfaceMesh square(double width, double height) {
  SurfaceMesh mesh;
  mesh.points = {{0, 0, height}, {width, 0, height}, {width, 1, height}, {0, 1, height}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// From a part of a square to all of it there is no distance; back there is.
TEST(SampledDistance, IsOneSided) {
  const auto above = sampled_distance(square(1, 0), square(1, 0.25));
  EXPECT_EQ(above.largest, 0.25);
  EXPECT_EQ(above.mean, 0.25);
  EXPECT_EQ(above.root_mean_square, 0.25);
  EXPECT_EQ(sampled_distance(square(1, 0), square(3, 0)).largest, 0);
  const auto back = sampled_distance(square(3, 0), square(1, 0));
  EXPECT_EQ(back.largest, 2);
  EXPECT_EQ(back.where.x, 3);
  EXPECT_LT(back.mean, 2);
}

class SurfaceProgram : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome run = run_program({"extract", field("s4_slab"), "-o", surface_, "--mode", "0.7",
                                     "--mode", "0.8", "--resolution", "1"});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  Folder folder_;
  std::string surface_ = folder_ / "surface.vtp";
};

TEST_F(SurfaceProgram, ReportsComponentsQualityCurvatureAndDistances) {
  const std::string output = folder_ / "curved.vtp";
  const Outcome run = run_program({"analyze", surface_, "--mesh", field("s4_slab"), "--against",
                                   surface_, "-o", output, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  const std::size_t triangles = json.at("surface").at("triangles");
  double area = 0;
  std::size_t counted = 0;
  for (const Json& part : json.at("components")) {
    area += part.at("area").get<double>();
    counted += part.at("triangles").get<std::size_t>();
    EXPECT_TRUE(part.at("mode") == 0.7 || part.at("mode") == 0.8);
  }
  EXPECT_EQ(counted, triangles);
  EXPECT_NEAR(area, json.at("surface").at("area").get<double>(), 1e-9 * area);
  for (const std::string name : {"smallest_angle", "aspect_ratio"}) {
    std::size_t in_histogram = 0;
    for (const Json& row : json.at("quality").at(name))
      in_histogram += row.at("triangles").get<std::size_t>();
    EXPECT_EQ(in_histogram, triangles);
  }
  EXPECT_EQ(json.at("curvature").at("vertices"), json.at("surface").at("vertices"));
  EXPECT_LT(json.at("distance").at("hausdorff").get<double>(), 1e-9);
  const std::string written = contents(output);
  for (const std::string name :
       {"\"principal_curvatures\"", "\"principal_direction_2\"", "\"normal_jump\""})
    EXPECT_NE(written.find(name), std::string::npos) << name;
  // What was written can be read again, and is the same surface.
  const Outcome again = run_program({"analyze", output, "--against", surface_, "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out).at("components"), json.at("components"));
}

#if TENSORTOPO_HAS_JETS
TEST_F(SurfaceProgram, FitsJetsToTheTriangles) {
  const std::string output = folder_ / "curved.vtp";
  const Outcome run = run_program({"analyze", surface_, "--mesh", field("s4_slab"), "--smooth",
                                   "-o", output, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_GT(json.at("smooth_curvature").at("vertices"), 0);
  EXPECT_GT(json.at("curvature").at("vertices"), 0);
  EXPECT_NE(contents(output).find("\"smooth_mean_curvature\""), std::string::npos);
}
#else
TEST_F(SurfaceProgram, SaysThatItHasNoJets) {
  const Outcome run = run_program({"analyze", surface_, "--smooth"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("TENSORTOPO_WITH_CGAL_GPL"), std::string::npos) << run.err;
}
#endif

TEST_F(SurfaceProgram, WritesRidgesWhoseEndsAddUp) {
  for (const bool recover : {false, true}) {
    const std::string ridges = folder_ / "ridges.vtp";
    std::vector<std::string> words{"analyze",  surface_, "--mesh", field("s4_slab"),
                                   "--ridges", ridges,   "--json"};
    if (recover) words.push_back("--recover");
    const Outcome run = run_program(words);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json.contains("recovered_curvature"), recover);
    EXPECT_EQ(json.contains("recovered_umbilics"), recover);
    const std::size_t triangles = json.at("surface").at("triangles");
    if (recover)
      for (const Json& umbilic : json.at("recovered_umbilics")) {
        EXPECT_EQ(std::abs(umbilic.at("index").get<double>()), 0.5);
        EXPECT_LT(umbilic.at("triangle").get<std::size_t>(), triangles);
      }
    for (const std::string kind : {"ridges", "valleys"}) {
      const Json& sum = json.at("ridges").at(kind);
      std::size_t ends = 0;
      EXPECT_EQ(sum.at("ends").at("rim"), sum.at("ends").at("boundary"));  // the old key of it
      for (const auto& [reason, count] : sum.at("ends").items())
        if (reason != "rim") ends += count.get<std::size_t>();
      const std::size_t lines = sum.at("lines"), closed = sum.at("closed");
      EXPECT_GT(lines, 0u);
      EXPECT_EQ(ends, 2 * (lines - closed));
      EXPECT_GT(sum.at("length").get<double>(), sum.at("crest_length").get<double>());
      // Recovered curvatures are continuous across faces of the mesh.
      EXPECT_EQ(sum.at("ends").at("face") == 0, recover);
      EXPECT_EQ(sum.at("bridges") == 0, recover);
    }
    const std::string written = contents(ridges);
    for (const std::string name : {"\"kind\"", "\"curvature\"", "\"strength\"", "\"length\""})
      EXPECT_NE(written.find(name), std::string::npos) << name;
  }
}

TEST_F(SurfaceProgram, LeavesOutFaintAndShortRidgesAndCountsThem) {
  const std::string ridges = folder_ / "ridges.vtp";
  const auto analyzed = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"analyze",  surface_, "--mesh",    field("s4_slab"),
                                   "--ridges", ridges,   "--recover", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out).at("ridges");
  };
  const Json all = analyzed({});
  const double strength = all.at("ridges").at("strength_of_all_lines").at("median");
  const Json some = analyzed({"--ridge-strength", std::to_string(strength), "--ridge-length", "1"});
  EXPECT_EQ(some.at("least_length"), 1);
  for (const std::string kind : {"ridges", "valleys"}) {
    const Json &whole = all.at(kind), &sum = some.at(kind);
    EXPECT_EQ(whole.at("left_out").at("lines"), 0);
    const std::size_t lines = sum.at("lines"), left_out = sum.at("left_out").at("lines");
    EXPECT_GT(left_out, 0u);
    EXPECT_GT(lines, 0u);
    EXPECT_EQ(lines + left_out, whole.at("lines").get<std::size_t>());
    EXPECT_EQ(sum.at("strength_of_all_lines"), whole.at("strength_of_all_lines"));
  }
}

TEST(InvariantSurface, ReportsItsValuesAndRefusesTheModesCurvature) {
  const Folder folder;
  const std::string surface = folder / "value.vtp";
  const Outcome extract = run_program({"extract", field("s4_slab"), "-o", surface, "--invariant",
                                       "deviator-magnitude", "--value", "1/4", "--value", "1/2"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  const Outcome run = run_program({"analyze", surface, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  std::set<double> values;
  const Json json = Json::parse(run.out);
  for (const Json& part : json.at("components")) {
    values.insert(part.at("value").get<double>());
    EXPECT_FALSE(part.contains("mode"));
  }
  EXPECT_EQ(values, (std::set<double>{0.25, 0.5}));
  const Outcome curved = run_program({"analyze", surface, "--mesh", field("s4_slab")});
  EXPECT_EQ(curved.status, 3);
  EXPECT_NE(curved.err.find("another invariant"), std::string::npos) << curved.err;
}

// A script over many modes goes on where the field has no such surface.
TEST(EmptySurface, IsAnalysed) {
  const Folder folder;
  const std::string mesh = folder / "g.vtu", none = folder / "none.vtp", some = folder / "some.vtp",
                    output = folder / "curved.vtp", ridges = folder / "ridges.vtp";
  ASSERT_EQ(run_program({"generate", "linear", "-o", mesh, "--field-only"}).status, 0);
  ASSERT_EQ(run_program({"extract", mesh, "-o", none, "--mode", "0.999"}).status, 0);
  ASSERT_EQ(run_program({"extract", mesh, "-o", some, "--mode", "0.1"}).status, 0);
  std::vector<std::string> words{"analyze", none,        "--mesh", mesh, "--recover", "--ridges",
                                 ridges,    "--against", some,     "-o", output};
#if TENSORTOPO_HAS_JETS
  words.push_back("--smooth");
#endif
  const Outcome text = run_program(words);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("0 triangles"), std::string::npos) << text.out;
  EXPECT_EQ(text.out.find("nan"), std::string::npos) << text.out;
  words.push_back("--json");
  const Outcome run = run_program(words);
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("surface").at("triangles"), 0);
  EXPECT_EQ(json.at("surface").at("area"), 0);
  EXPECT_TRUE(json.at("components").empty());
  EXPECT_TRUE(json.at("quality").at("least_angle").is_null());
  EXPECT_EQ(json.at("curvature").at("vertices"), 0);
  EXPECT_TRUE(json.at("umbilics").empty());
  for (const char* name : {"forth", "back", "hausdorff"})
    EXPECT_TRUE(json.at("distance").at(name).is_null()) << name;
  // What is written is a surface again.
  for (const std::string& file : {output, ridges})
    EXPECT_EQ(run_program({"analyze", file}).status, 0) << file;
  const Outcome back = run_program({"analyze", some, "--against", none, "--json"});
  ASSERT_EQ(back.status, 0) << back.err;
  EXPECT_TRUE(Json::parse(back.out).at("distance").at("forth").is_null());
}

TEST(EmptySurface, IsNotAFileOfCurvesNorOneThatIsNone) {
  const Folder folder;
  const std::string curves = folder / "curves.vtp", none = folder / "none.vtp";
  ASSERT_EQ(run_program({"extract", field("s4_slab"), "-o", curves, "--mode", "1"}).status, 0);
  std::ofstream(folder / "none.vtp") << "no surface\n";
  for (const std::string& file : {curves, none})
    EXPECT_EQ(run_program({"analyze", file}).status, 3) << file;
}

TEST_F(SurfaceProgram, RefusesAMeshThatIsNotItsOwn) {
  const Outcome run = run_program({"analyze", surface_, "--mesh", field("s2_pushpull")});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("another field"), std::string::npos) << run.err;
}

/// Other tensors on the same mesh.
TEST_F(SurfaceProgram, RefusesAFieldThatIsNotItsOwn) {
  const std::string other = folder_ / "other.vtu", picture = folder_ / "picture.png";
  ASSERT_EQ(run_program({"convert", field("s4_slab"), "-o", other, "--zero-below", "1e-300"}).status, 0);
  for (const auto& words : {std::vector<std::string>{"analyze", surface_, "--mesh", other},
                            {"render", surface_, "--mesh", other, "--texture", "major", "-o", picture}}) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("another field"), std::string::npos) << run.err;
  }
  // The outline of another mesh may be drawn beside it, which is said.
  const Outcome drawn = run_program({"render", surface_, "--mesh", other, "-o", picture});
  EXPECT_EQ(drawn.status, 0);
  EXPECT_NE(drawn.err.find("another file"), std::string::npos) << drawn.err;
  // What an analysis writes says as much of its field.
  const std::string with_curvature = folder_ / "curvature.vtp";
  ASSERT_EQ(run_program({"analyze", surface_, "--mesh", field("s4_slab"), "-o", with_curvature}).status, 0);
  EXPECT_EQ(run_program({"analyze", with_curvature, "--mesh", other}).status, 3);
}

TEST_F(SurfaceProgram, RefusesWhatMakesNoSense) {
  const std::string picture = folder_ / "picture.png", output = folder_ / "output.vtp";
  EXPECT_EQ(run_program({"analyze", surface_, "--sweep", "0:1:3"}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "--smooth", "-o", picture}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "-o", output}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "--ridges", output}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "--recover"}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "--ridge-strength", "1"}).status, 2);
  EXPECT_EQ(run_program({"analyze", surface_, "--mesh", field("s4_slab"), "--ridges", output,
                         "--ridge-length=-1"})
                .status,
            2);
  EXPECT_EQ(run_program({"analyze", field("s4_slab")}).status, 2);
  EXPECT_EQ(run_program({"analyze", field("s4_slab"), "--sweep", "0:1:3", "--smooth"}).status, 2);
  EXPECT_EQ(run_program({"analyze", folder_ / "nowhere.vtp"}).status, 3);
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"surface.vtp"});
}

}  // namespace
}  // namespace tensortopo::test
