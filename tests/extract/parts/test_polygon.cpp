// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/polygon.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

// "" if the triangles cut the polygon 0 1 ... n-1: n - 2 of them, every side of the polygon once
// and in its direction, every diagonal twice, once each way, and in no face.
std::string flaws_of_cut(const std::vector<PolygonCorner>& corners, const Triangles& triangles) {
  const int n = static_cast<int>(corners.size());
  if (static_cast<int>(triangles.size()) != n - 2) return "wrong number of triangles";
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < 0 || t[i] >= n) return "no such corner";
      ++sides[{t[i], t[(i + 1) % 3]}];
    }
  for (const auto& [side, count] : sides) {
    const auto [u, v] = side;
    if (count != 1) return "two triangles run along one side the same way";
    if (v == (u + 1) % n) continue;
    if (!sides.contains({v, u})) return "a diagonal has one triangle";
    if ((corners[static_cast<std::size_t>(u)].faces & corners[static_cast<std::size_t>(v)].faces) !=
        0)
      return "a diagonal lies in a face";
  }
  for (int i = 0; i < n; ++i)
    if (!sides.contains({i, (i + 1) % n})) return "a side of the polygon has no triangle";
  return "";
}

double length_of_diagonals(const std::vector<PolygonCorner>& corners, const Triangles& triangles) {
  double sum = 0;
  const int n = static_cast<int>(corners.size());
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int u = t[i], v = t[(i + 1) % 3];
      if (v == (u + 1) % n || u > v) continue;
      const auto d = corners[static_cast<std::size_t>(u)].position -
                     corners[static_cast<std::size_t>(v)].position;
      sum += std::sqrt(dot(d, d));
    }
  return sum;
}

// Least total length over all cuts, by trying all apexes over each base.
double least_length(const std::vector<PolygonCorner>& corners, std::size_t i, std::size_t j,
                    bool whole = true) {
  double own = 0;
  if (!whole && j > i + 1) {
    if ((corners[i].faces & corners[j].faces) != 0) return INFINITY;
    const auto d = corners[i].position - corners[j].position;
    own = std::sqrt(dot(d, d));
  }
  if (j - i < 2) return 0;
  double best = INFINITY;
  for (std::size_t k = i + 1; k < j; ++k)
    best = std::min(best, least_length(corners, i, k, false) + least_length(corners, k, j, false));
  return own + best;
}

// A boundary loop as a sheet has it: runs through faces, edge points between them on two faces.
std::vector<PolygonCorner> random_loop(Random& random, int faces, int most) {
  std::vector<PolygonCorner> corners;
  std::vector<int> order{0, 1, 2, 3};
  for (std::size_t i = 3; i > 0; --i)
    std::swap(order[i], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  for (int f = 0; f < faces; ++f) {
    const int face = order[static_cast<std::size_t>(f % 4)],
              before = order[static_cast<std::size_t>((f + faces - 1) % faces % 4)];
    const auto bit = [](int k) { return 1u << k; };
    const auto add = [&](unsigned set) {
      corners.push_back(
          {{random.normal(), random.normal(), random.normal()}, static_cast<std::uint8_t>(set)});
    };
    if (faces > 1) add(bit(face) | bit(before));
    for (int k = random.integer(faces > 1 ? 0 : 3, most); k > 0; --k) add(bit(face));
  }
  return corners;
}

TEST(CutPolygon, GivesTrianglesWithoutDiagonalsInFacesAndOfLeastLength) {
  const std::uint64_t seed = 20240601;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int cut = 0, refused = 0;
  for (int trial = 0; trial < trials(2000, 1000); ++trial) {
    const auto corners = random_loop(random, random.integer(1, 4), trial % 20 == 0 ? 4 : 2);
    if (corners.size() < 3) continue;
    const auto triangles = cut_polygon(corners);
    const double least = least_length(corners, 0, corners.size() - 1);
    const bool one_face =
        corners.size() == 3 && (corners[0].faces & corners[1].faces & corners[2].faces) != 0;
    if (triangles.empty()) {
      ++refused;
      EXPECT_TRUE(one_face || std::isinf(least)) << "trial " << trial;
      continue;
    }
    ++cut;
    EXPECT_EQ(flaws_of_cut(corners, triangles), "") << "trial " << trial;
    EXPECT_NEAR(length_of_diagonals(corners, triangles), least, 1e-9) << "trial " << trial;
  }
  EXPECT_GT(cut, 400);
  EXPECT_GT(refused, 100);
}

TEST(CutPolygon, CutsLongRimsCornerByCorner) {
  const std::uint64_t seed = 20261122;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int cut = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto corners = random_loop(random, random.integer(2, 4), 900);
    if (corners.size() <= kLargestShortest) continue;
    const auto triangles = cut_polygon(corners);
    if (triangles.empty()) continue;  // all corners that are left may lie on one face
    ++cut;
    EXPECT_EQ(flaws_of_cut(corners, triangles), "") << "trial " << trial;
  }
  EXPECT_GT(cut, trials(60) / 3);
}

TEST(CutPolygon, RefusesWhatLiesInOneFace) {
  std::vector<PolygonCorner> corners(5);
  for (std::size_t i = 0; i < 5; ++i)
    corners[i] = {
        {std::cos(1.2 * static_cast<double>(i)), std::sin(1.2 * static_cast<double>(i)), 0}, 1};
  EXPECT_TRUE(cut_polygon(corners).empty());
  corners.resize(3);
  EXPECT_TRUE(cut_polygon(corners).empty());
  corners.resize(2);
  EXPECT_TRUE(cut_polygon(corners).empty());
  for (const std::size_t many : {kSmallPolygon + 5, kLargestShortest + 5}) {
    corners.resize(many, {{2, 0, 0}, 1});
    EXPECT_TRUE(cut_polygon(corners).empty());
  }
}

}  // namespace
}  // namespace tensortopo::test
