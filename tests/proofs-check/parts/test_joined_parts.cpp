// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What borders of parts come to when they are put together.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parts/join_parts.hpp"
#include "parts/match_chains.hpp"

namespace certificate {
namespace {

/// An arc from a crossing of an edge of the face to one of another.
BorderChain arc(std::uint32_t face, std::array<ChainEnd, 2> ends, std::array<BorderPlace, 2> places,
                std::array<std::uint32_t, 2> vertices, std::uint32_t component = 0) {
  return {face, {false, ends, {}}, {places[0], places[1]}, {vertices[0], vertices[1]}, component};
}

/// The chain as the part on the other side has it.
void turn(BorderChain& chain) {
  std::swap(chain.curve.ends[0], chain.curve.ends[1]);
  std::reverse(chain.places.begin(), chain.places.end());
  std::reverse(chain.vertices.begin(), chain.vertices.end());
}

constexpr std::array<BorderPlace, 2> kOnX{{{0, 0, 0}, {1, 0, 0}}}, kOnY{{{0, 0, 0}, {0, 1, 0}}},
    kOnZ{{{0, 0, 0}, {0, 0, 1}}};

/// A part with one triangle, that has an edge on the face with corners 0, x and y.
PartBorder part(int side) {
  PartBorder border;
  border.points = {{{0, 0, 0}, {1, 0, 0, 0, 0, 0}},
                   {{0, 1, 0}, {2, 0, 0, 0, 0, 0}},
                   {{1, 0, 0}, {3, 0, 0, 0, 0, 0}}};
  border.faces = {{{0, 1, 2}, side}};
  const ChainEnd x{1, kOnX}, y{1, kOnY}, z{1, kOnZ};
  const BorderPlace at_x{0.5, 0, 0}, at_y{0, 0.5, 0}, at_z{0, 0, 0.5};
  border.chains = {arc(0, {x, y}, {at_x, at_y}, {0, 1}), arc(1, {y, z}, {at_y, at_z}, {1, 2}),
                   arc(2, {z, x}, {at_z, at_x}, {2, 0})};
  for (const double height : {1.0, 2.0}) {  // faces that no other part has
    const auto n = static_cast<std::uint32_t>(border.points.size());
    border.points.push_back({{0, 0, height * side}, {}});
    border.points.push_back({{1, 0, height * side}, {}});
    border.points.push_back({{0, 1, height * side}, {}});
    border.faces.push_back({{n, n + 2, n + 1}, side});
  }
  if (side < 0)
    for (BorderChain& chain : border.chains) turn(chain);
  border.components = {{3, 3, 1, {}}};
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

TEST(JoinedParts, OtherCurvesAndPlacesAreRefuted) {
  PartBorder other = part(-1);
  other.chains[0].places[0][1] = 0x1.0000000000001p-1;
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  other.chains[0].curve.ends[0].crossing = 2;  // of the same place
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  turn(other.chains[0]);  // in the same direction
  expect_refuted({part(1), other}, "only");
  other = part(-1);
  other.chains.erase(other.chains.begin());
  expect_refuted({part(1), other}, "in part 0 only");
  other = part(-1);
  other.chains[0].places.insert(other.chains[0].places.begin() + 1, {0.25, 0.25, 0});
  other.chains[0].vertices.insert(other.chains[0].vertices.begin() + 1, 3);
  expect_refuted({part(1), other}, "in part 0 only");
}

/// A part with two triangles that both have an edge on the face with corners 0, x and y, between
/// the same places: one from the first crossing on x to the first one on y, one back between the
/// second ones.
PartBorder part_with_two(int side) {
  PartBorder border = part(1), more = part(1);
  for (BorderChain& chain : more.chains) {
    for (auto& v : chain.vertices) v += 3;
    for (auto& end : chain.curve.ends) end.crossing = 2;
    chain.component = 1;
    turn(chain);
    border.chains.push_back(chain);
  }
  border.components.push_back(border.components[0]);
  if (side > 0) return border;
  for (BorderChain& chain : border.chains) turn(chain);
  border.faces[0].side = -1;
  for (BorderPoint& point : border.points) point.place[2] *= -1;
  return border;
}

TEST(JoinedParts, CrossingsTellWhichVertexAtOnePlaceIsWhich) {
  const PartBorder one = part_with_two(1);
  PartBorder other = part_with_two(-1);
  const Outcome outcome = join({one, other});
  ASSERT_EQ(outcome.status, "certified");
  EXPECT_EQ(outcome.whole->vertices, 8U);
  EXPECT_EQ(outcome.whole->components.size(), 2U);
  EXPECT_EQ(outcome.whole->boundary_loops, 2U);
  // The arcs join other crossings.
  std::swap(other.chains[0].curve.ends[0], other.chains[3].curve.ends[1]);
  expect_refuted({one, other}, "only");
}

/// A part with as many discs, each of which ends at a closed curve with three vertices on the face
/// with corners 0, x and y.
PartBorder part_with_closed(int side, const std::vector<std::size_t>& numbers) {
  PartBorder border = part(side);
  border.chains.clear(), border.components.clear();
  for (std::uint32_t n = 0; n < numbers.size(); ++n) {
    const double x = 0.25 + 0.01 * static_cast<double>(numbers[n]);
    BorderChain chain{0,
                      {true, {}, numbers[n]},
                      {{x, 0.25, 0}, {x, 0.5, 0}, {0.25, x, 0}},
                      {3 * n, 3 * n + 1, 3 * n + 2},
                      n};
    if (side < 0) turn(chain);
    border.chains.push_back(chain);
    border.components.push_back({3, 3, 1, {}});
  }
  return border;
}

TEST(JoinedParts, ClosedCurvesAreGluedByNumberWhereverTheyBegin) {
  const PartBorder one = part_with_closed(1, {0, 1});
  PartBorder other = part_with_closed(-1, {1, 0});
  for (BorderChain& chain : other.chains) {
    std::rotate(chain.places.begin(), chain.places.begin() + 1, chain.places.end());
    std::rotate(chain.vertices.begin(), chain.vertices.begin() + 1, chain.vertices.end());
  }
  const Outcome outcome = join({one, other});
  ASSERT_EQ(outcome.status, "certified");
  EXPECT_EQ(outcome.whole->components.size(), 2U);
  EXPECT_EQ(outcome.whole->euler_characteristic, 4);
  EXPECT_EQ(outcome.whole->vertices, 6U);
  EXPECT_EQ(outcome.whole->boundary_loops, 0U);
  PartBorder exchanged = other;
  std::swap(exchanged.chains[0].curve.number, exchanged.chains[1].curve.number);
  EXPECT_EQ(join({one, exchanged}).status, "undecided");  // places say otherwise
  PartBorder unknown = other;
  unknown.chains[1].curve.number.reset();
  EXPECT_EQ(join({one, unknown}).status, "undecided");
  other.chains[1].places[2][0] = 0.125;
  expect_refuted({one, other}, "in part 0 only");
  EXPECT_EQ(join({one, part_with_closed(-1, {0})}).status, "refuted");
}

/// Places may repeat: any turn that fits will do, and none that does not.
TEST(JoinedParts, TurnsAreFoundWherePlacesRepeat) {
  const BorderPlace p{0, 0, 0}, q{1, 0, 0};
  const auto closed = [](std::vector<BorderPlace> places) {
    const std::vector<std::uint32_t> vertices(places.size());
    return BorderChain{0, {true, {}, 0}, std::move(places), vertices, 0};
  };
  std::size_t found = 0;
  for (unsigned bits = 0; bits < 64; ++bits)
    for (unsigned other_bits = 0; other_bits < 64; ++other_bits) {
      std::vector<BorderPlace> here, there;
      for (unsigned i = 0; i < 6; ++i) {
        here.push_back((bits >> i & 1U) != 0 ? q : p);
        there.push_back((other_bits >> i & 1U) != 0 ? q : p);
      }
      const auto turn = turn_between(closed(here), closed(there));
      const auto fits = [&](std::size_t t) {
        for (std::size_t i = 0; i < 6; ++i)
          if (here[i] != there[(t + 6 - i) % 6]) return false;
        return true;
      };
      bool is_there = false;
      for (std::size_t t = 0; t < 6; ++t) is_there = is_there || fits(t);
      ASSERT_EQ(turn.has_value(), is_there) << bits << ' ' << other_bits;
      if (turn) {
        ASSERT_TRUE(fits(*turn));
        ++found;
      }
    }
  EXPECT_GT(found, 64U);
}

TEST(JoinedParts, NumbersOfComponentsAreCompared) {
  PartBorder one = part(1), other = part(-1), apart = part(-1);
  for (BorderPoint& point : apart.points) point.place[0] += 8;
  const auto with = [](PartBorder border, std::optional<double> whole) {
    border.components[0].said.whole = whole;
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
  several.components[0].said.whole_is_one = false;
  expect_refuted({several, with(other, 0), with(apart, 1)}, "several numbers");
}

}  // namespace
}  // namespace certificate
