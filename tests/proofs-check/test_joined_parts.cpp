// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What borders of parts come to when they are put together.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "parts/join_parts.hpp"

namespace certificate {
namespace {

/// A part with one triangle, that has an edge on the face with corners 0, x and y.
PartBorder part(int side) {
  PartBorder border;
  border.points = {{{0, 0, 0}, {1, 0, 0, 0, 0, 0}},
                   {{0, 1, 0}, {2, 0, 0, 0, 0, 0}},
                   {{1, 0, 0}, {3, 0, 0, 0, 0, 0}}};
  border.faces = {{{0, 1, 2}, side}};
  const SurfaceEnd a{{0.5, 0, 0}, 1}, b{{0, 0.5, 0}, 1}, c{{0, 0, 0.5}, 1};
  border.edges = {{0, {a, b}, {0, 1}, 0}, {1, {b, c}, {1, 2}, 0}, {2, {c, a}, {2, 0}, 0}};
  for (const double z : {1.0, 2.0}) {  // faces that no other part has
    const auto n = static_cast<std::uint32_t>(border.points.size());
    border.points.push_back({{0, 0, z * side}, {}});
    border.points.push_back({{1, 0, z * side}, {}});
    border.points.push_back({{0, 1, z * side}, {}});
    border.faces.push_back({{n, n + 2, n + 1}, side});
  }
  if (side < 0)
    for (SurfaceEdge& edge : border.edges) {
      std::swap(edge.ends[0], edge.ends[1]);
      std::swap(edge.vertices[0], edge.vertices[1]);
    }
  border.components = {{3, 3, 1, std::nullopt, true}};
  border.is_complete = true;
  return border;
}

struct Outcome {
  std::string status;
  std::string derived;  ///< of all refutations
  std::optional<JoinedSurface> whole;
};

Outcome join(const std::vector<PartBorder>& borders) {
  Report report;
  Ledger ledger(report);
  Outcome outcome;
  outcome.whole = join_parts(borders, ledger);
  outcome.status = report.status();
  for (const Finding& finding : report.refutations) outcome.derived += finding.derived + '\n';
  EXPECT_EQ(outcome.whole.has_value() && report.refuted == 0, outcome.status == "certified");
  return outcome;
}

void expect_refuted(const std::vector<PartBorder>& borders, const std::string& text) {
  const Outcome outcome = join(borders);
  EXPECT_EQ(outcome.status, "refuted") << text;
  EXPECT_NE(outcome.derived.find(text), std::string::npos) << outcome.derived;
}

TEST(JoinedParts, TwoTrianglesAtAnEdgeAreADisc) {
  const Outcome outcome = join({part(1), part(-1)});
  ASSERT_EQ(outcome.status, "certified");
  EXPECT_EQ(outcome.whole->vertices, 4U);
  EXPECT_EQ(outcome.whole->triangles, 2U);
  ASSERT_EQ(outcome.whole->components.size(), 1U);
  EXPECT_EQ(outcome.whole->euler_characteristic, 1);
  EXPECT_EQ(outcome.whole->boundary_loops, 1U);
}

TEST(JoinedParts, PartsThatDoNotTouchStayApart) {
  PartBorder other = part(-1);
  for (BorderPoint& point : other.points) point.place[0] += 8;
  const Outcome outcome = join({part(1), other});
  ASSERT_EQ(outcome.status, "certified");
  EXPECT_EQ(outcome.whole->components.size(), 2U);
  EXPECT_EQ(outcome.whole->euler_characteristic, 2);
  EXPECT_EQ(outcome.whole->boundary_loops, 2U);
}

TEST(JoinedParts, TetrahedraOnOneSideAndThreeAreRefuted) {
  PartBorder same = part(-1);
  same.faces[0].side = 1;
  expect_refuted({part(1), same}, "both on the same side");
  expect_refuted({part(1), part(-1), part(-1)}, "3 tetrahedra");
}

TEST(JoinedParts, OtherTensorsAreRefuted) {
  PartBorder other = part(-1);
  other.points[2].tensor[5] = 1e-300;
  expect_refuted({part(1), other}, "different tensors in parts 0 and 1");
  other = part(-1);
  other.points[1].tensor[3] = -0.0;  // equal
  EXPECT_EQ(join({part(1), other}).status, "certified");
}

TEST(JoinedParts, OtherEdgesAreRefuted) {
  PartBorder other = part(-1);
  other.edges[0].ends[0].place[1] = 0x1.0000000000001p-1;
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  other.edges[0].ends[0].crossing = 2;  // of the same place
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  std::swap(other.edges[0].ends[0], other.edges[0].ends[1]);  // in the same direction
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  other.edges.erase(other.edges.begin());
  expect_refuted({part(1), other}, "in part 0 only");
}

TEST(JoinedParts, TwoEdgesAtOnePlaceStayOpen) {
  PartBorder one = part(1), other = part(-1);
  one.edges.push_back(one.edges[0]);
  other.edges.push_back(other.edges[0]);
  EXPECT_EQ(join({one, other}).status, "undecided");
}

// Places do not tell which of two vertices is meant: arcs may be exchanged.
TEST(JoinedParts, TwoVerticesAtOnePlaceStayOpen) {
  PartBorder one = part(1), other = part(-1);
  for (PartBorder* border : {&one, &other}) {
    SurfaceEdge more = border->edges[0];
    std::swap(more.ends[0], more.ends[1]);
    for (auto& v : more.vertices) v += 100;
    border->edges.push_back(more);
  }
  EXPECT_NE(join({one, other}).status, "certified");
}

TEST(JoinedParts, NumbersOfComponentsAreCompared) {
  PartBorder one = part(1), other = part(-1), apart = part(-1);
  for (BorderPoint& point : apart.points) point.place[0] += 8;
  const auto with = [](PartBorder border, std::optional<double> whole) {
    border.components[0].whole = whole;
    return border;
  };
  EXPECT_EQ(join({with(one, 1), with(other, 1), with(apart, 0)}).status, "certified");
  expect_refuted({with(one, 1), with(other, 0), with(apart, 0)}, "another number");
  expect_refuted({with(one, 0), with(other, 0), with(apart, 0)}, "the number of another");
  expect_refuted({with(one, 0), with(other, 0), with(apart, 2)}, "no number");
  expect_refuted({with(one, 0), with(other, 0), with(apart, -1)}, "no number");
  expect_refuted({with(one, 0), with(other, 0), with(apart, 0.5)}, "no number");
  expect_refuted({with(one, 0), with(other, std::nullopt), with(apart, 1)}, "no array");
  PartBorder several = with(one, 0);
  several.components[0].whole_is_one = false;
  expect_refuted({several, with(other, 0), with(apart, 1)}, "several numbers");
}

}  // namespace
}  // namespace certificate
