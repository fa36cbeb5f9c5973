// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tensortopo/persistence/persistence_pairs.hpp"

namespace tensortopo::test {
namespace {

ModeMaximum maximum(double low, double high) {
  ModeMaximum made;
  made.mode = {low, high};
  return made;
}

ModeMaximum curve(std::size_t number, double length) {
  ModeMaximum made = maximum(1, 1);
  made.curve = number;
  made.length = length;
  return made;
}

ModeMerge merge(double low, double high, std::vector<std::size_t> reached, bool is_proved = true) {
  ModeMerge made;
  made.mode = {low, high};
  made.reached = std::move(reached);
  made.is_proved = is_proved;
  return made;
}

TEST(PersistencePairs, YoungerOnesDie) {
  MergeTree tree;
  tree.maxima = {maximum(0.5, 0.51), maximum(0.9, 0.91), maximum(0.7, 0.71)};
  tree.merges = {merge(0.3, 0.31, {0, 2}), merge(0.1, 0.11, {0, 1})};
  const auto pairs = persistence_pairs(tree);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].merge, std::optional<std::size_t>(0));
  EXPECT_EQ(pairs[1].merge, std::nullopt);
  EXPECT_EQ(pairs[2].merge, std::optional<std::size_t>(1));
  for (const MergePair& pair : pairs) EXPECT_TRUE(pair.is_certain && !pair.is_tie);
}

// Components that meet along two paths meet at the higher one.
TEST(PersistencePairs, SecondMeetingIsNone) {
  MergeTree tree;
  tree.maxima = {maximum(0.8, 0.8), maximum(0.9, 0.9)};
  tree.merges = {merge(0.3, 0.31, {0, 1}), merge(0.1, 0.11, {1, 0})};
  const auto pairs = persistence_pairs(tree);
  EXPECT_EQ(pairs[0].merge, std::optional<std::size_t>(0));
  EXPECT_FALSE(pairs[0].is_tie);
  // The two enclosures overlap: either may be the place.
  tree.merges[1].mode = {0.29, 0.305};
  EXPECT_TRUE(persistence_pairs(tree)[0].is_tie);
}

TEST(PersistencePairs, BirthsThatOverlapAreTies) {
  MergeTree tree;
  tree.maxima = {maximum(0.5, 0.52), maximum(0.51, 0.53)};
  tree.merges = {merge(0.1, 0.11, {0, 1})};
  const auto pairs = persistence_pairs(tree);
  EXPECT_EQ(pairs[0].merge, std::optional<std::size_t>(0));
  EXPECT_TRUE(pairs[0].is_tie);
  EXPECT_FALSE(pairs[1].is_tie);
}

TEST(PersistencePairs, OfCurvesTheLongerIsTheOlder) {
  MergeTree tree;
  tree.maxima = {curve(0, 1), curve(1, 3), curve(2, 3)};
  tree.merges = {merge(0.5, 0.5, {0, 1}), merge(0.2, 0.2, {0, 2})};
  const auto pairs = persistence_pairs(tree);
  EXPECT_EQ(pairs[0].merge, std::optional<std::size_t>(0));
  EXPECT_FALSE(pairs[0].is_tie);
  EXPECT_EQ(pairs[1].merge, std::nullopt);
  EXPECT_EQ(pairs[2].merge, std::optional<std::size_t>(1));
  EXPECT_TRUE(pairs[2].is_tie);
}

// A point that may have joined the component before leaves its pair open; one below does not.
TEST(PersistencePairs, UnprovedPointsMakePairsUncertain) {
  MergeTree tree;
  tree.maxima = {maximum(0.9, 0.9), maximum(0.8, 0.8), maximum(0.7, 0.7)};
  tree.merges = {merge(0.6, 0.61, {1, 0}, false), merge(0.5, 0.5, {0, 1}), merge(0.1, 0.1, {0, 2}),
                 merge(0, 0.01, {2}, false)};
  const auto pairs = persistence_pairs(tree);
  EXPECT_FALSE(pairs[1].is_certain);
  EXPECT_TRUE(pairs[2].is_certain);
  EXPECT_EQ(pairs[1].merge, std::optional<std::size_t>(1));
}

}  // namespace
}  // namespace tensortopo::test
