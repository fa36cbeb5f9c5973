// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "isotopy/apart.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "surface/embedded.hpp"

namespace certificate {
namespace {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// Two triangles with no, one or two vertices in common.
constexpr std::array<Triangle, 3> kOthers{{{3, 4, 5}, {0, 3, 4}, {1, 0, 3}}};

std::vector<BallPoint> enclosed(const std::vector<Point>& points, double error) {
  std::vector<BallPoint> result;
  for (const Point& p : points)
    result.push_back({Ball(p[0], error), Ball(p[1], error), Ball(p[2], error)});
  return result;
}

bool is_embedded(const std::vector<Point>& points, const Triangle& other) {
  return !find_conflict(points, std::array<Triangle, 2>{{{0, 1, 2}, other}}).conflict;
}

/// What is shown to stay apart is so wherever corners are, in exact arithmetic; and without errors
/// it is shown of whatever is apart, but next to where that changes.
TEST(Isotopic, WhatIsApartStaysApart) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t shown = 0, moved = 0, missed = 0, conflicts = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Point> points(6);
    for (Point& p : points)
      for (double& x : p) x = round % 2 == 0 ? any(random) : std::round(4 * any(random));
    const double error = round % 3 == 0 ? 0 : std::abs(any(random)) * 0.2;
    for (const Triangle& other : kOthers) {
      const auto balls = enclosed(points, error);
      const bool is_shown = has_area(balls[0], balls[1], balls[2]) &&
                            has_area(balls[other[0]], balls[other[1]], balls[other[2]]) &&
                            are_apart(balls, {0, 1, 2}, other);
      if (!is_shown) {
        const bool is_apart = is_embedded(points, other);
        if (error == 0) ++(is_apart ? missed : conflicts);
        continue;
      }
      ++shown;
      for (int k = 0; k < 8; ++k) {
        std::vector<Point> elsewhere = points;
        for (Point& p : elsewhere)
          for (double& x : p)
            x += k == 0 ? 0 : k < 4 ? (random() % 2 == 0 ? error : -error) : error * any(random);
        EXPECT_TRUE(is_embedded(elsewhere, other)) << round;
        ++moved;
      }
    }
  }
  EXPECT_GT(shown, 2000u);
  EXPECT_GT(moved, 16000u);
  EXPECT_GT(conflicts, 100u);
  EXPECT_EQ(missed, 0u) << shown << " shown";
}

/// Nine vectors, as two triangles have, of which each has a positive product with some direction
/// wherever it is within its errors, however large these are beside it.
TEST(Isotopic, ACommonSideIsFoundWhereThereIsOne) {
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t found = 0;
  constexpr std::size_t kRounds = 2000;
  for (std::size_t round = 0; round < kRounds; ++round) {
    const Point d{any(random), any(random), any(random)};
    std::vector<BallPoint> vectors;
    while (vectors.size() < 9) {
      BallPoint v;
      double least = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        v[k] = Ball(any(random), std::abs(any(random)));
        least += d[k] * v[k].value - std::abs(d[k]) * v[k].error;
      }
      if (least > 0.02) vectors.push_back(v);
    }
    if (have_common_side(vectors)) ++found;
  }
  EXPECT_EQ(found, kRounds);
}

/// Needles: one corner of a triangle is so far from a side of the other as crossings may be from a
/// vertex of the mesh, ten thousand times what rounding makes of it.
TEST(Isotopic, NeedlesAreApart) {
  std::size_t apart = 0, tried = 0;
  for (int power = 10; power <= 41; ++power, ++tried) {
    const double s = std::ldexp(1, -power);
    const std::vector<Point> points{{1.5, 0.5 + s, 0},
                                    {2 - s, 1, 0.5 - s},
                                    {2 - s, 1, 0},
                                    {1.5 - s, 0.5, 0},
                                    {2 - 2 * s, 1 - s, 0.5 - s}};
    apart += are_apart(enclosed(points, 1e-16), {0, 1, 2}, {3, 4, 0}) ? 1u : 0u;
  }
  EXPECT_EQ(apart, tried);
}

/// Triangles on both sides of their common edge are apart however sharp the fold is.
TEST(Isotopic, SharpFoldsAreApart) {
  std::size_t apart = 0;
  for (const double angle : {1e-2, 1e-8, 1e-11, 1e-14}) {
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.4, 1.1, angle}};
    apart += are_apart(enclosed(points, 1e-17), {0, 1, 2}, {0, 1, 3}) ? 1u : 0u;
  }
  EXPECT_EQ(apart, 4u);
}

}  // namespace
}  // namespace certificate

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Tetrahedra with faces of angles down to 2^-38: places in them are found as well as in others.
TEST(Isotopic, OfThinTetrahedra) {
  Court court("thin_tetrahedra");
  std::size_t isotopic = 0;
  for (int power = 20; power <= 38; power += 3)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      TetMesh mesh = cube_mesh(1);
      fill_with_normal_tensors(mesh, seed);
      for (auto& p : mesh.points) p = {p.x + p.z, p.y + p.z, std::ldexp(p.z, -power)};
      const Exhibit shown = exhibit(mesh, {"1/2"});
      EXPECT_EQ(court.verdict(shown), "certified") << power << '\n' << court.report();
      isotopic += court.report().find("isotopic to the level in ") != std::string::npos ? 1u : 0u;
    }
  EXPECT_GT(isotopic, 15u);
}

/// Whatever the unit of coordinates is: places are found in edges and faces of any size.
TEST(Isotopic, InAnyUnitOfCoordinates) {
  Court court("units");
  for (const double unit : {1e-90, 1e-24, 1e-16, 1e90})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      TetMesh mesh = cube_mesh(1);
      fill_with_normal_tensors(mesh, seed);
      for (auto& p : mesh.points) p = unit * p;
      EXPECT_EQ(court.verdict(exhibit(mesh, {"1/2"})), "certified") << unit << '\n'
                                                                    << court.report();
    }
}

/// Made where triangles are embedded, and derived; what is excepted cannot be shown.
TEST(Isotopic, IsAClaimThatIsDerived) {
  Court court("isotopic");
  std::size_t claimed = 0, excepted = 0, shown = 0;
  for (const Exhibit& honest : honest_exhibits()) {
    ASSERT_EQ(court.verdict(honest), "certified") << court.report();
    for (std::size_t l = 0; l < honest.certificate["levels"].size(); ++l) {
      const Json& level = honest.certificate["levels"][l];
      EXPECT_EQ(level.contains("isotopic"), level.contains("embedded"));
      if (!level.contains("isotopic")) continue;
      ++claimed;
      shown += court.report().find("isotopic to the level in ") != std::string::npos ? 1u : 0u;
      Exhibit e = honest;
      Json& forged = e.certificate["levels"][l];
      if (!level["isotopic"]["except"].empty()) {
        ++excepted;
        forged["isotopic"]["except"] = Json::array();
        EXPECT_EQ(court.verdict(e), "undecided") << court.report();
        EXPECT_NE(court.report().find("isotopic: not shown in tetrahedron"), std::string::npos)
            << court.report();
      }
      forged["isotopic"]["except"] = {1000000};
      EXPECT_EQ(court.verdict(e), "refuted") << court.report();
      forged = level;
      forged.erase("embedded");
      EXPECT_EQ(court.verdict(e), "undecided") << court.report();
    }
  }
  EXPECT_GT(claimed, 3u);
  EXPECT_GT(excepted, 0u);
  EXPECT_GT(shown, 3u);
}

}  // namespace
}  // namespace tensortopo::test
