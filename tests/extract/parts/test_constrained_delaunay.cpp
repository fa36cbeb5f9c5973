// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/delaunay/constrained_delaunay.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "extract/parts/plane_cases.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Index = ConstrainedDelaunay::Index;
using Point = ConstrainedDelaunay::Point;

RC_GTEST_PROP(ConstrainedDelaunay, IsWhatTheHeaderDescribes, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto c = random_plane_case(random);
  ConstrainedDelaunay triangulation;
  RC_ASSERT(insert(c, triangulation));
  triangulation.number_regions();
  RC_ASSERT(flaws_of(c, triangulation) == "");
}

TEST(ConstrainedDelaunay, IsSoForManyCasesOfEachKind) {
  Compared with_regions("cases with regions", 100), on_lines("cases on one line", 5),
      ties("edges between four corners on one circle", 1000);
  std::mt19937 random(20261128);
  for (int trial = trials(3000); trial > 0; --trial) {
    const auto c = random_plane_case(random);
    ConstrainedDelaunay triangulation;
    ASSERT_TRUE(insert(c, triangulation));
    triangulation.number_regions();
    ASSERT_EQ(flaws_of(c, triangulation), "");
    with_regions.count(c.has_regions);
    on_lines.count(finite_triangles(triangulation).empty() && c.points.size() > 2);
    for (const auto& t : triangulation.triangles())
      for (std::size_t i = 0; i < 3; ++i) {
        const Index d =
            triangulation.triangles()[t.beyond[i].triangle()].corners[t.beyond[i].corner()];
        ties.count(!ConstrainedDelaunay::is_infinite(t) && d != ConstrainedDelaunay::kInfinite &&
                   exact_in_circle(c, t.corners[0], t.corners[1], t.corners[2], d) == 0);
      }
  }
}

TEST(ConstrainedDelaunay, DoesNotDependOnTheOrderOfInsertion) {
  Compared compared("cases", 100), splits("cases with points on segments", 50);
  std::mt19937 random(7);
  for (int trial = trials(800); trial > 0; --trial) {
    auto c = random_plane_case(random);
    ConstrainedDelaunay at_once, one_by_one;
    ASSERT_TRUE(insert(c, at_once));
    // Each segment as soon as its ends are there: points on it split it.
    std::shuffle(c.segments.begin(), c.segments.end(), random);
    std::vector<PlaneCase::Segment> late;
    PlaneCase so_far;
    for (const auto& p : c.points) {
      const std::size_t i = so_far.points.size();
      so_far.points.push_back(p);
      ASSERT_TRUE(one_by_one.insert(std::span(&p, 1)));
      for (auto segment : c.segments) {
        if (std::max(segment[0], segment[1]) != i) continue;
        if (random() % 2 == 0) std::swap(segment[0], segment[1]);
        // Segments that meet in a point which is not there yet would cross.
        if (std::any_of(so_far.segments.begin(), so_far.segments.end(), [&](const auto& other) {
              return are_in_conflict(so_far, segment, other);
            })) {
          late.push_back(segment);
          continue;
        }
        so_far.segments.push_back(segment);
        ASSERT_TRUE(
            one_by_one.constrain(static_cast<Index>(segment[0]), static_cast<Index>(segment[1])));
      }
    }
    for (const auto& [a, b] : late)
      ASSERT_TRUE(one_by_one.constrain(static_cast<Index>(a), static_cast<Index>(b)));
    splits.count(one_by_one.has_split_segments());
    EXPECT_FALSE(at_once.has_split_segments());
    EXPECT_EQ(finite_triangles(at_once), finite_triangles(one_by_one));
    one_by_one.number_regions();
    EXPECT_EQ(flaws_of(c, one_by_one), "");
    ++compared;
  }
}

TEST(ConstrainedDelaunay, RefusesSegmentsThatCrossAndPointsThatCoincide) {
  Compared crossings("segments that cross others or cover them", 100),
      copies("points that coincide", 100);
  std::mt19937 random(11);
  for (int trial = trials(1500); trial > 0; --trial) {
    const auto c = random_plane_case(random);
    ConstrainedDelaunay triangulation;
    ASSERT_TRUE(insert(c, triangulation));
    const auto last = c.points.size() - 1;
    std::uniform_int_distribution<std::size_t> any(0, last);
    const PlaneCase::Segment s{any(random), any(random)};
    const bool crosses = std::any_of(c.segments.begin(), c.segments.end(), [&](const auto& t) {
      return s[0] != s[1] && are_in_conflict(c, s, t);
    });
    EXPECT_NE(triangulation.constrain(static_cast<Index>(s[0]), static_cast<Index>(s[1])), crosses);
    crossings.count(crosses);
    const Point copy = c.points[any(random)];
    EXPECT_FALSE(triangulation.insert(std::span(&copy, 1)));
    ++copies;
  }
  ConstrainedDelaunay triangulation;
  const Point infinite{0, INFINITY};
  EXPECT_FALSE(triangulation.insert(std::span(&infinite, 1)));
}

TEST(ConstrainedDelaunay, FindsPlaces) {
  Compared inside("places in triangles", 1000), outside("places outside", 1000);
  std::mt19937 random(13);
  for (int trial = trials(400); trial > 0; --trial) {
    auto c = random_plane_case(random);
    ConstrainedDelaunay triangulation;
    ASSERT_TRUE(insert(c, triangulation));
    const std::size_t count = c.points.size();
    for (int i = 0; i < 40; ++i) {
      const int reach = c.has_regions ? 4000 : 12;
      std::uniform_int_distribution<int> any(-reach, reach);
      const Point at =
          i % 4 == 0 ? c.points[random() % count] : Point{1.0 * any(random), 1.0 * any(random)};
      c.points.resize(count);
      c.points.push_back(at);
      const Index found = triangulation.locate(at);
      if (count < 2) {
        EXPECT_EQ(found, ConstrainedDelaunay::kNone);
        continue;
      }
      const auto& t = triangulation.triangles()[found];
      bool seen = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t.corners[(k + 1) % 3], b = t.corners[(k + 2) % 3];
        if (a == ConstrainedDelaunay::kInfinite || b == ConstrainedDelaunay::kInfinite) continue;
        const auto turn = exact_turn(c, a, b, count);
        EXPECT_GE(turn, 0);
        seen |= turn > 0;
      }
      // On the line that all points are on, nothing tells inside from outside.
      const bool is_infinite = ConstrainedDelaunay::is_infinite(t);
      if (is_infinite && !seen) {
        EXPECT_TRUE(finite_triangles(triangulation).empty());
      }
      (is_infinite ? outside : inside).count();
    }
  }
}

TEST(ConstrainedDelaunay, HoldsAFewPoints) {
  ConstrainedDelaunay triangulation;
  EXPECT_TRUE(triangulation.insert({}));
  EXPECT_EQ(triangulation.locate({0, 0}), ConstrainedDelaunay::kNone);
  triangulation.number_regions();
  PlaneCase c;
  for (const Point p : {Point{0, 0}, Point{2, 2}, Point{1, 1}, Point{-3, -3}, Point{5, 5},
                        Point{1, -1}, Point{-4, 0}}) {
    c.points.push_back(p);
    ASSERT_TRUE(triangulation.insert(std::span(&p, 1)));
    triangulation.number_regions();
    EXPECT_EQ(flaws_of(c, triangulation), "");
    if (c.points.size() == 4) {
      c.segments.push_back({3, 1});
      ASSERT_TRUE(triangulation.constrain(3, 1));
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
