// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What curves of parts come to when they are put together.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "parts/join_curves.hpp"

namespace certificate {
namespace {

/// A part with one face that others may have, and two lines that end there.
PartCurves curve_part(int side) {
  PartCurves part;
  part.points = {{{0, 0, 0}, {1, 0, 0, 0, 0, 0}},
                 {{0, 1, 0}, {2, 0, 0, 0, 0, 0}},
                 {{1, 0, 0}, {3, 0, 0, 0, 0, 0}}};
  part.faces = {{{0, 1, 2}, side}};
  // Both at one place, as rounding may have it.
  part.ends = {{0, 0, 0, {0.25, 0.25, 0}}, {0, 1, 2, {0.25, 0.25, 0}}};
  part.component = {0, 0, 1, 1};
  part.line_ends = {1, 1, 1, 1};
  part.components = {{2, 1, {}}, {2, 1, {}}};
  return part;
}

struct Joined {
  std::string status, derived;
  std::optional<JoinedCurves> whole;
};

Joined glue(const std::vector<PartCurves>& parts) {
  Report report;
  Ledger ledger(report);
  Joined result;
  result.whole = join_curves(parts, ledger);
  result.status = report.status();
  for (const Finding& finding : report.refutations) result.derived += finding.derived + '\n';
  EXPECT_EQ(result.whole.has_value() && report.refuted == 0, result.status == "certified");
  return result;
}

void expect_curves_refuted(const std::vector<PartCurves>& parts, const std::string& text) {
  const Joined joined = glue(parts);
  EXPECT_EQ(joined.status, "refuted") << text;
  EXPECT_NE(joined.derived.find(text), std::string::npos) << joined.derived;
}

TEST(JoinedCurves, LinesAreGluedAtPoints) {
  const Joined joined = glue({curve_part(1), curve_part(-1)});
  ASSERT_EQ(joined.status, "certified");
  EXPECT_EQ(joined.whole->vertices, 6U);
  EXPECT_EQ(joined.whole->lines, 4U);
  EXPECT_EQ(joined.whole->components.size(), 2U);
  EXPECT_EQ(joined.whole->closed, 0U);
}

TEST(JoinedCurves, ALineThatGoesBackClosesTheCurve) {
  PartCurves back = curve_part(1), other = curve_part(-1);
  for (PartCurves* part : {&back, &other}) {
    part->ends[1].vertex = 1;
    part->component = {0, 0}, part->line_ends = {1, 1};
    part->components = {{2, 1, {}}};
  }
  const Joined joined = glue({back, other});
  ASSERT_EQ(joined.status, "certified");
  EXPECT_EQ(joined.whole->vertices, 2U);
  EXPECT_EQ(joined.whole->closed, 1U);
  EXPECT_EQ(glue({back}).whole->closed, 0U);
}

TEST(JoinedCurves, PointsAreKnownByNumbersNotByPlaces) {
  // The first line of one part goes on in the second of the other.
  PartCurves other = curve_part(-1);
  std::swap(other.ends[0].number, other.ends[1].number);
  other.components[1] = {2, 5, {}};
  const Joined joined = glue({curve_part(1), other});
  ASSERT_EQ(joined.status, "certified");
  EXPECT_EQ(joined.whole->components[0].cells, 6U);
  EXPECT_EQ(joined.whole->components[1].cells, 2U);
}

TEST(JoinedCurves, WhatDoesNotFitIsRefuted) {
  PartCurves other = curve_part(-1);
  other.ends.pop_back();
  expect_curves_refuted({curve_part(1), other}, "2 in part 0, 1 in part 1");
  other = curve_part(-1);
  other.ends[1].place[1] = 0x1.0000000000001p-2;
  expect_curves_refuted({curve_part(1), other}, "in part 1");
  other = curve_part(-1);
  other.points[1].tensor[3] = 1e-300;
  expect_curves_refuted({curve_part(1), other}, "different tensors in parts 0 and 1");
  expect_curves_refuted({curve_part(1), curve_part(1)}, "both on the same side");
  expect_curves_refuted({curve_part(1), curve_part(-1), curve_part(-1)}, "3 tetrahedra");
}

TEST(JoinedCurves, PointsThatAreNotToldStayOpen) {
  PartCurves other = curve_part(-1);
  other.ends[0].number.reset();
  EXPECT_EQ(glue({curve_part(1), other}).status, "undecided");
}

TEST(JoinedCurves, NumbersOfComponentsAreCompared) {
  const auto with = [](PartCurves part, double first, double second) {
    part.components[0].said.whole = first, part.components[1].said.whole = second;
    return part;
  };
  const PartCurves one = curve_part(1), other = curve_part(-1);
  EXPECT_EQ(glue({with(one, 0, 1), with(other, 0, 1)}).status, "certified");
  EXPECT_EQ(glue({with(one, 1, 0), with(other, 1, 0)}).status, "certified");
  expect_curves_refuted({with(one, 0, 1), with(other, 1, 0)}, "another number");
  expect_curves_refuted({with(one, 0, 0), with(other, 0, 0)}, "the number of another");
  expect_curves_refuted({with(one, 0, 2), with(other, 0, 2)}, "no number");
  expect_curves_refuted({with(one, 0, 1), other}, "no array");
}

}  // namespace
}  // namespace certificate
