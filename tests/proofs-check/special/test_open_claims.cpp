// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is true is never refuted, also where no proof closes or doubles do not hold what is
// compared.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "proofs-check/forgeries/forgery.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

std::string text_of(double x, const char* format) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// All lengths, those that are claimed too, times a power of two.
Exhibit scaled(Exhibit e, int exponent) {
  const double factor = std::ldexp(1.0, exponent);
  for (auto& p : e.mesh.points) p = factor * p;
  for (auto& p : e.surface.points) p = factor * p;
  Json& distance = e.certificate["levels"][0]["distance"];
  for (Json& reach : distance["reach"]) reach = reach.get<int>() + 4 * exponent;
  for (const char* bound : {"bound", "coarse_bound"})
    distance[bound] =
        text_of(factor * std::strtod(distance[bound].get<std::string>().c_str(), nullptr), "%a");
  e.rehash();
  return e;
}

/// The magnitude of T(p) is least at (1, 1, 1) / 4, and the value next to that.
TEST(OpenClaims, AClosedSheetInAnUndecidedTetrahedronIsNotRefuted) {
  Court court("closed_sheet");
  TetTensors tensors;
  for (std::size_t i = 0; i < 4; ++i)
    tensors[i] = {1, 0, 0, i == 1 ? 0.75 : -0.25, i == 2 ? 0.75 : -0.25, i == 3 ? 0.75 : -0.25};
  const TetMesh mesh = reference_tet_mesh(tensors);
  const Exhibit near = exhibit(mesh, {"magnitude 1125899906842625/1125899906842624"});
  ASSERT_GT(near.surface.triangles.size(), 0u);
  EXPECT_EQ(court.verdict(near), "undecided") << court.report();
  EXPECT_NE(court.report().find("what it is compared with is not derived"), std::string::npos)
      << court.report();
  Exhibit sphere = exhibit(mesh, {"magnitude 101/100"});
  ASSERT_EQ(court.verdict(sphere), "certified") << court.report();
  for (auto& t : sphere.surface.triangles) std::swap(t[0], t[1]);
  sphere.rehash();
  EXPECT_EQ(court.verdict(sphere), "refuted") << court.report();
}

/// A closed curve about a vertex with much smaller tensors, whose points are one in doubles.
TEST(OpenClaims, ACurveThatIsOnePointIsNotRefutedInAnyUnit) {
  Court court("collapsed_curve");
  const TetTensors tensors{
      {{0.7970360930293934, -0.5163564195891688, -0.9043719830269183, -0.26061648836561346,
        0.44574869178802845, 0.042285512013748194},
       {-9.664533130785492e+299, -5.692143120164163e+300, 8.183485010445796e+300,
        -6.949764208271713e+300, -7.501263742270307e+300, -5.284126696580838e+300},
       {-5.208674591062776e-302, 7.816201253000254e-302, -5.882848543696105e-302,
        3.32429395078355e-302, 2.0577316524849218e-302, 1.782882917297616e-302},
       {-3.968e-320, 6.1037e-320, -5.1077e-320, -4.3354e-320, -3.214e-320, -2.759e-320}}};
  for (const int exponent : {-300, 0, 250, 300}) {
    TetMesh mesh = reference_tet_mesh(tensors);
    for (auto& p : mesh.points) p = std::ldexp(1.0, exponent) * p;
    EXPECT_EQ(court.verdict(exhibit(mesh, {"99/100"})), "undecided") << exponent << '\n'
                                                                     << court.report();
  }
}

/// A sheet near a face, and a point of its triangles next to the vertex opposite: the longest edge
/// is not a bound any more, if that is so small, and the sheet not farther from the point.
TEST(OpenClaims, ATrueBoundOfLargeLengthsIsNotRefuted) {
  Court court("far_point");
  Exhibit e = exhibit(reference_tet_mesh({{{-1, -1, 2, 0, 0, 0},
                                           {3, -3, 0, 0, 0, 0},
                                           {3, -3, 0, 0.25, 0, 0},
                                           {3, -3, 0, 0, 0.25, 0}}}),
                      {"1/2"});
  ASSERT_EQ(e.surface.triangles.size(), 1u);
  ASSERT_EQ(court.verdict(e), "certified") << court.report();
  e.surface.points.push_back({0.9921875, 0.001953125, 0.001953125});
  e.surface.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  e.surface.tet = {0, 0, 0};
  e.certificate["surface"]["vertices"] = 4, e.certificate["surface"]["triangles"] = 3;
  Json& level = e.certificate["levels"][0];
  level["vertices"] = {0, 4}, level["triangles"] = {0, 3};
  level["components"][0]["triangles"] = 3;
  level.erase("embedded"), level.erase("isotopic");
  level["distance"] = {{"reach", {-58, -58, -58, -58}}, {"bound", "0x0p+0"}, {"coarse", {0}}};
  std::size_t refuted = 0;
  for (const char* bound : {"0x1p-4", "0x1p-1", "0x1.bp-1", "0x1p+0", "0x1.3p+0"}) {
    level["distance"]["coarse_bound"] = bound;
    e.rehash();
    const std::string verdict = court.verdict(e);
    if (verdict == "refuted") ++refuted;
    const std::string large = court.verdict(scaled(e, 513));
    EXPECT_TRUE(large == "undecided" || large == verdict) << bound << '\n' << court.report();
  }
  EXPECT_GT(refuted, 0u);
}

/// Squares of lengths from 2^512 on are not finite.
TEST(OpenClaims, BoundsOfCoarseTetrahedraAreRefutedInAnyUnitOrInNone) {
  Court court("large_coarse_bound");
  std::size_t certified = 0, refuted = 0, open = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Exhibit e = exhibit(reference_tet_mesh(Random(seed).tet_tensors()), {"1/2"});
    Json& distance = e.certificate["levels"][0]["distance"];
    if (distance["coarse"].empty()) continue;
    for (const char* bound : {"0x1.8p+0", "0x1p+0", "0x1p-1", "0x1p-9"}) {
      distance["coarse_bound"] = bound;
      const std::string verdict = court.verdict(e);
      for (const int exponent : {400, 513}) {
        const std::string large = court.verdict(scaled(e, exponent));
        if (exponent == 400)
          EXPECT_EQ(large, verdict) << seed << ' ' << bound << '\n' << court.report();
        else
          EXPECT_TRUE(large == verdict || large == "undecided")
              << verdict << seed << ' ' << bound << '\n'
              << court.report();
        if (large == "certified") ++certified;
        if (large == "refuted") ++refuted;
        if (large == "undecided") ++open;
      }
    }
  }
  EXPECT_GT(certified, 5u);
  EXPECT_GT(refuted, 5u);
  EXPECT_GT(open, 5u);
}

/// Nothing is shown of the parts of a tetrahedron with a vertex of zero deviator.
TEST(OpenClaims, ABoundOfACoarseConeBelowItsEdgeIsNotRefuted) {
  Court court("coarse_cone");
  TetTensors tensors = Random(3).tet_tensors();
  tensors[0] = {};
  Exhibit e = exhibit(reference_tet_mesh(tensors), {"1/4"});
  ASSERT_GT(e.certificate["levels"][0]["cones"].size(), 0u);
  ASSERT_EQ(court.verdict(e), "certified") << court.report();
  Json& distance = e.certificate["levels"][0]["distance"];
  distance["coarse"] = {0};
  distance["coarse_bound"] = "0x1.6ap+0";  // the longest edge is the root of two
  EXPECT_EQ(court.verdict(e), "undecided") << court.report();
  distance["coarse_bound"] = "0x1.6bp+0";
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
}

/// Levels next to those of a vertex. With small integers some edges leave it at a right angle to
/// the gradient: next to it rounding hides where they are crossed upwards.
TEST(OpenClaims, LevelsNextToAVertexAreCertified) {
  Court court("next_to_vertex");
  std::size_t certified = 0, open = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const auto entry = [&] { return static_cast<double>(random.integer(-1, 1)); };
    TetTensors tensors;
    for (auto& t : tensors) t = {entry(), entry(), entry(), entry(), entry(), entry()};
    const auto& t = tensors[1];
    const double magnitude = std::sqrt(t.xx * t.xx + t.yy * t.yy + t.zz * t.zz +
                                       2 * (t.xy * t.xy + t.yz * t.yz + t.xz * t.xz));
    const double mode = magnitude > 0 ? tensortopo::mode(deviator(t)) : 1;
    std::vector<std::string> levels;
    for (const double to : {-10.0, 10.0}) {
      if (magnitude > 0)
        levels.push_back("magnitude " + text_of(std::nextafter(magnitude, to), "%.17g"));
      if (mode != 0 && std::abs(mode) < 0.999)
        levels.push_back(text_of(std::nextafter(mode, to), "%.17g"));
    }
    for (const std::string& level : levels) {
      const Exhibit e = exhibit(reference_tet_mesh(tensors), {level});
      const std::string verdict = court.verdict(e);
      EXPECT_NE(verdict, "refuted") << seed << ' ' << level << court.report();
      // What the extractor leaves open itself does not count.
      if (!e.certificate["levels"][0]["undecided"].empty()) continue;
      ++(verdict == "certified" ? certified : open);
    }
  }
  EXPECT_GT(certified, 100u);
  // Where a whole face is tangent, directions across it are hidden as well.
  EXPECT_LE(open, 1u);
}

}  // namespace
}  // namespace tensortopo::test
