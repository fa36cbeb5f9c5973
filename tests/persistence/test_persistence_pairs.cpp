// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
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
  (is_proved ? made.reached : made.possible.emplace()) = std::move(reached);
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
  // Either may be the one that lasts.
  EXPECT_TRUE(pairs[0].is_tie);
  EXPECT_TRUE(pairs[1].is_tie);
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
  // It may come before.
  tree.merges.back().mode.high = 0.1;
  EXPECT_FALSE(persistence_pairs(tree)[2].is_certain);
  // What is not known to be elsewhere may join any.
  tree.merges.pop_back();
  EXPECT_TRUE(persistence_pairs(tree)[2].is_certain);
  tree.merges.front().possible.reset();
  for (const auto& pair : persistence_pairs(tree)) EXPECT_FALSE(pair.is_certain);
}

// A merge with a wide enclosure may come after several with narrow ones, not only after the next.
TEST(PersistencePairs, WideEnclosuresAreComparedWithAllThatFollow) {
  MergeTree tree;
  tree.maxima = {maximum(0.99, 0.99), maximum(0.95, 0.95), maximum(0.97, 0.97), maximum(0.9, 0.9)};
  tree.merges = {merge(0.1, 0.9, {0, 1}), merge(0.48, 0.49, {0, 3}), merge(0.3, 0.31, {1, 2})};
  // With 0.15 in the first one the second maximum dies at the last.
  const auto pairs = persistence_pairs(tree);
  EXPECT_TRUE(pairs[1].is_tie);
  EXPECT_TRUE(pairs[2].is_tie);
}

/// Merges of as many maxima, with enclosures of any width.
MergeTree random_tree(Random& random) {
  MergeTree tree;
  const int count = random.integer(3, 8);
  const auto range = [&](double from) {
    const double middle = from + 0.5 * random.uniform();
    const double half = std::ldexp(random.uniform(), -random.integer(2, 12));
    return ModeRange{middle - half, middle + half};
  };
  for (int i = 0; i < count; ++i) {
    const ModeRange mode = range(0.4);
    tree.maxima.push_back(maximum(mode.low, mode.high));
  }
  for (int i = 0; i < 2 * count; ++i) {
    const ModeRange mode = range(-0.4);
    const int a = random.integer(0, count - 1), b = random.integer(0, count - 2);
    tree.merges.push_back(merge(mode.low, mode.high,
                                {static_cast<std::size_t>(a), static_cast<std::size_t>(b + (b >= a))}));
  }
  std::stable_sort(tree.merges.begin(), tree.merges.end(), [](const auto& a, const auto& b) {
    return a.mode.middle() > b.mode.middle();
  });
  return tree;
}

// Whatever the values are in their enclosures, a pair that is certain and no tie is one of theirs.
TEST(PersistencePairs, AreThoseOfAllValuesInTheEnclosures) {
  Compared compared("pairs", 1000);
  Random random(20261126);
  for (int k = 0; k < trials(2000); ++k) {
    const MergeTree tree = random_tree(random);
    const auto pairs = persistence_pairs(tree);
    for (int j = 0; j < 8; ++j) {
      const auto value_in = [&](const ModeRange& range) {
        const double value = range.low + (range.high - range.low) * random.uniform();
        return ModeRange{value, value};
      };
      MergeTree values = tree;
      for (auto& each : values.maxima) each.mode = value_in(each.mode);
      std::vector<std::size_t> order(tree.merges.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      for (auto& each : values.merges) each.mode = value_in(each.mode);
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return values.merges[a].mode.low > values.merges[b].mode.low;
      });
      MergeTree sorted = values;
      for (std::size_t i = 0; i < order.size(); ++i) sorted.merges[i] = values.merges[order[i]];
      const auto of_values = persistence_pairs(sorted);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!pairs[i].is_certain || pairs[i].is_tie) continue;
        ++compared;
        ASSERT_EQ(pairs[i].merge.has_value(), of_values[i].merge.has_value()) << k;
        if (!pairs[i].merge) continue;
        ASSERT_EQ(*pairs[i].merge, order[*of_values[i].merge]) << k;
      }
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
