// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/embedded.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "proofs-check/forgeries/forgery.hpp"
#include "proofs-check/forgeries/lies.hpp"

namespace certificate {
namespace {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

bool is_embedded(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  const EmbeddingResult result = find_conflict(points, triangles);
  EXPECT_TRUE(result.decided);
  return !result.conflict;
}

TEST(Embedded, PairsInEveryPosition) {
  const std::vector<Point> p{{0, 0, 0},  {4, 0, 0}, {0, 4, 0},    // 0-2
                             {1, 1, -1}, {1, 1, 1}, {5, 5, 1},    // 3-5 through it
                             {1, 1, 0},  {2, 1, 0}, {1, 2, 0},    // 6-8 inside, in its plane
                             {4, 4, 0},  {0, 0, 4}, {-1, -1, 0},  // 9-11
                             {2, 2, 0},  {2, 2, 3}, {9, 9, 3}};   // 12-14: touches an edge
  const Triangle first{0, 1, 2};
  const auto with = [&](const Triangle& t) { return is_embedded(p, {first, t}); };
  EXPECT_FALSE(with({3, 4, 5}));     // no common vertex, through
  EXPECT_FALSE(with({6, 7, 8}));     // coplanar, inside
  EXPECT_FALSE(with({12, 13, 14}));  // touches
  EXPECT_TRUE(with({4, 5, 10}));     // apart
  EXPECT_FALSE(with({0, 3, 4}));     // one common vertex, through
  EXPECT_FALSE(with({0, 7, 8}));     // coplanar sectors that overlap
  EXPECT_TRUE(with({0, 10, 4}));     // one common vertex, apart
  EXPECT_TRUE(with({0, 11, 10}));
  EXPECT_TRUE(with({2, 1, 9}));                // a common edge, flat
  EXPECT_TRUE(with({2, 1, 10}));               // a common edge, folded
  EXPECT_FALSE(with({2, 1, 6}));               // folded onto it
  EXPECT_FALSE(with({0, 2, 1}));               // twice
  EXPECT_FALSE(is_embedded(p, {{0, 6, 12}}));  // without area
  EXPECT_TRUE(is_embedded(p, {first}));
  EXPECT_TRUE(is_embedded(p, {}));
}

/// A height field is embedded, however steep; a vertex through its neighbours is not.
TEST(Embedded, HeightFields) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> height(-20, 20);
  constexpr std::uint32_t kSize = 24;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i <= kSize; ++i)
    for (std::uint32_t j = 0; j <= kSize; ++j)
      points.push_back({static_cast<double>(i), static_cast<double>(j), height(random)});
  const auto at = [](std::uint32_t i, std::uint32_t j) { return i * (kSize + 1) + j; };
  for (std::uint32_t i = 0; i < kSize; ++i)
    for (std::uint32_t j = 0; j < kSize; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  EXPECT_TRUE(is_embedded(points, triangles));
  // Two at one place, or one in another triangle's inside, to the last bit.
  auto forged = points;
  forged.push_back(points[at(5, 5)]);
  auto more = triangles;
  more.push_back({static_cast<std::uint32_t>(points.size()), at(0, 0), at(1, 1)});
  EXPECT_FALSE(is_embedded(forged, more));
  forged = points;
  forged[at(9, 9)][0] -= 2.5;
  EXPECT_FALSE(is_embedded(forged, triangles));
}

}  // namespace
}  // namespace certificate

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Where the claim is made it is derived, and it is made where it holds: two programs without
/// common code agree.
TEST(Embedded, IsAClaimThatIsDerived) {
  Court court("embedded");
  std::size_t certified = 0, refuted = 0;
  for (const Exhibit& honest : honest_exhibits()) {
    Exhibit e = honest;
    const auto& levels = honest.certificate["levels"];
    const bool is_claimed = std::all_of(
        levels.begin(), levels.end(), [](const Json& level) { return level.contains("embedded"); });
    for (Json& level : e.certificate["levels"]) level["embedded"] = true;
    const std::string verdict = court.verdict(e);
    (verdict == "certified" ? certified : refuted) += 1;
    EXPECT_EQ(verdict == "certified", is_claimed) << court.report();
    EXPECT_EQ(verdict == "certified", court.report().find("refuted: ") == std::string::npos)
        << court.report();
    for (Json& level : e.certificate["levels"]) level["embedded"] = false;
    EXPECT_EQ(court.verdict(e), "refuted");
  }
  EXPECT_GT(certified, 3u) << certified << " certified, " << refuted << " refuted";
}

/// A vertex inside a tetrahedron pushed through the rest of its sheet, all hashes right.
TEST(Embedded, CutsAreFound) {
  Court court("cuts");
  Pick pick(3);
  std::size_t told = 0;
  for (const Exhibit& honest : honest_exhibits()) {
    Exhibit e = honest;
    for (Json& level : e.certificate["levels"])
      level["embedded"] = true, level["distance"] = nullptr;
    if (e.surface.triangles.empty() || court.verdict(e) != "certified") continue;
    const auto t = e.surface.triangles[pick.below(e.surface.triangles.size())];
    e.surface.points[static_cast<std::size_t>(t[0])] =
        e.surface.points[static_cast<std::size_t>(t[1])];
    e.rehash();
    EXPECT_EQ(court.verdict(e), "refuted") << court.report();
    ++told;
  }
  EXPECT_GT(told, 3u);
}

}  // namespace
}  // namespace tensortopo::test
