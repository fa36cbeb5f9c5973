// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <optional>
#include <utility>

#include "support/compared.hpp"
#include "tensortopo/persistence/loop_pairs.hpp"

namespace tensortopo::test {
namespace {

MergeTree tree_of(std::size_t maxima) {
  MergeTree tree;
  tree.maxima.resize(maxima);
  return tree;
}

ModeMerge meeting(double mode, std::vector<std::size_t> reached, std::size_t point) {
  ModeMerge made;
  made.mode = {mode, mode};
  made.reached = std::move(reached);
  made.is_proved = true;
  made.point = point;
  return made;
}

/// The number of the change is also that of its point.
LoopChange change(double mode, bool is_birth, std::optional<std::size_t> member,
                  std::size_t number) {
  LoopChange made;
  made.mode = {mode, mode};
  made.is_birth = is_birth;
  made.member = member;
  made.point = made.event = number;
  return made;
}

constexpr bool kBirth = true, kDeath = false;

TEST(LoopPairs, OneLoopInAComponentIsPaired) {
  const auto pairs = loop_pairs(tree_of(2),
                                {change(0.9, kBirth, 0, 0), change(0.8, kBirth, 1, 1),
                                 change(0.7, kDeath, 0, 2), change(0.6, kDeath, 1, 3)},
                                {});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(std::pair(pairs[0].birth, *pairs[0].death), std::pair(std::size_t{0}, std::size_t{2}));
  EXPECT_EQ(std::pair(pairs[1].birth, *pairs[1].death), std::pair(std::size_t{1}, std::size_t{3}));
  EXPECT_FALSE(pairs[0].is_tie || pairs[1].is_tie);
}

TEST(LoopPairs, TwoLoopsInAComponentAreLeftOpen) {
  std::vector<LoopChange> changes{change(0.9, kBirth, 0, 0), change(0.8, kBirth, 0, 1),
                                  change(0.7, kDeath, 0, 2), change(0.6, kDeath, 0, 3),
                                  change(0.5, kBirth, 0, 4), change(0.4, kDeath, 0, 5)};
  const auto later = loop_pairs(tree_of(1), changes, {});
  ASSERT_EQ(later.size(), 1u);
  EXPECT_EQ(later[0].birth, 4u);
  // Born at one mode, it does not matter which is which.
  changes[1].mode = changes[0].mode;
  EXPECT_EQ(loop_pairs(tree_of(1), changes, {}).size(), 3u);
}

TEST(LoopPairs, WhatDoesNotDieLasts) {
  std::vector<LoopChange> changes{change(0.9, kBirth, 0, 0), change(0.8, kBirth, 0, 1)};
  const auto both = loop_pairs(tree_of(1), changes, {});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_FALSE(both[0].death || both[1].death);
  changes.push_back(change(0.7, kDeath, 0, 2));
  EXPECT_TRUE(loop_pairs(tree_of(1), changes, {}).empty());
}

TEST(LoopPairs, WhatIsNotKnownIsNotPaired) {
  MergeTree tree = tree_of(2);
  const std::vector<LoopChange> changes{change(0.9, kBirth, 0, 0), change(0.7, kDeath, 0, 1),
                                        change(0.5, kBirth, 0, 2), change(0.3, kDeath, 0, 3)};
  EXPECT_EQ(loop_pairs(tree, changes, {}).size(), 2u);
  EXPECT_EQ(loop_pairs(tree, changes, {0}).size(), 0u);
  EXPECT_EQ(loop_pairs(tree, changes, {1}).size(), 2u);
  auto open = changes;
  open.push_back(change(0.6, kBirth, 0, 4));
  open.back().is_open = true;
  EXPECT_EQ(loop_pairs(tree, open, {}).size(), 1u);
  auto unknown = changes;
  unknown.push_back(change(0.8, kDeath, std::nullopt, 4));
  EXPECT_EQ(loop_pairs(tree, unknown, {}).size(), 0u);
  tree.merges = {meeting(0.6, {0, 1}, 5)};
  tree.merges[0].is_proved = false;
  EXPECT_EQ(loop_pairs(tree, changes, {}).size(), 1u);
}

TEST(LoopPairs, EnclosuresThatOverlapAreTies) {
  std::vector<LoopChange> changes{change(0.9, kBirth, 0, 0), change(0.7, kDeath, 0, 1),
                                  change(0.6, kBirth, 0, 2), change(0.5, kDeath, 0, 3)};
  for (const LoopPair& pair : loop_pairs(tree_of(1), changes, {})) EXPECT_FALSE(pair.is_tie);
  changes[2].mode = {0.5, 0.71};  // with the death before, and the one after
  const auto pairs = loop_pairs(tree_of(1), changes, {});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_TRUE(pairs[0].is_tie && pairs[1].is_tie);
}

// Components with loops in them that meet, and loops that vanish, any of those there: what is
// paired is paired rightly.
void look_at_any_process(Compared& compared) {
  MergeTree tree = tree_of(4);
  std::vector<std::size_t> component{0, 1, 2, 3};
  std::map<std::size_t, std::vector<std::size_t>> loops;  // of each component, their births
  std::map<std::size_t, std::size_t> death_of;
  std::vector<LoopChange> changes;
  for (std::size_t step = 0; step < 30; ++step) {
    const double mode = 0.9 - 0.05 * static_cast<double>(step);
    const auto member = *rc::gen::inRange<std::size_t>(0, 4);
    auto& here = loops[component[member]];
    const int what = *rc::gen::inRange(0, 8);
    if (what < 3) {
      here.push_back(step);
      changes.push_back(change(mode, kBirth, member, step));
    } else if (what < 7 && !here.empty()) {
      const auto which = *rc::gen::inRange<std::size_t>(0, here.size());
      death_of[here[which]] = step;
      here.erase(here.begin() + static_cast<std::ptrdiff_t>(which));
      changes.push_back(change(mode, kDeath, member, step));
    } else if (what == 7) {
      const auto other = *rc::gen::inRange<std::size_t>(0, 4);
      tree.merges.push_back(meeting(mode, {member, other}, step));
      const std::size_t from = component[other], to = component[member];
      if (from == to) continue;
      here.insert(here.end(), loops[from].begin(), loops[from].end());
      loops.erase(from);
      for (std::size_t& c : component)
        if (c == from) c = to;
    }
  }
  const auto pairs = loop_pairs(tree, changes, {});
  for (const LoopPair& pair : pairs) {
    RC_ASSERT(death_of.contains(pair.birth) == pair.death.has_value());
    RC_ASSERT(!pair.death || death_of[pair.birth] == *pair.death);
    RC_ASSERT(!pair.is_tie);
    ++compared;
  }
}

TEST(LoopPairs, AreThoseOfAnyProcess) {
  Compared compared("pairs", 50);
  EXPECT_TRUE(rc::check("pairs are right", [&] { look_at_any_process(compared); }));
}

}  // namespace
}  // namespace tensortopo::test
