// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The arcs of a face in which the level function increases along a direction, against all orders that
// its crossings can have.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "face_level.hpp"
#include "field.hpp"

namespace certificate {
namespace {

struct GivenTensors : ExactTensors {
  std::array<Tensor<mpz_class>, 3> all;
  Tensor<mpz_class> exact(std::uint32_t id) const override { return all[id]; }
};

using Arcs = std::set<std::set<Crossing>>;

/// The crossings of one of the two ways from the first corner to the last, in order.
std::vector<Crossing> along(const std::vector<std::size_t>& way,
                            const std::map<std::array<std::size_t, 2>, unsigned>& counts) {
  std::vector<Crossing> result;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const std::array edge{std::min(way[i], way[i + 1]), std::max(way[i], way[i + 1])};
    const unsigned n = counts.at(edge);
    for (unsigned k = 0; k < n; ++k) result.push_back({edge, way[i] < way[i + 1] ? k : n - 1 - k});
  }
  return result;
}

/// The arcs of all orders of the crossings of two ways in which no line enters above and leaves below.
class Orders {
 public:
  Orders(std::array<std::vector<Crossing>, 2> ways, bool above, bool above_at_end)
      : ways_(std::move(ways)), end_(above_at_end) {
    go({0, 0}, {above, above}, {}, {});
  }
  const std::set<Arcs>& found() const { return found_; }

 private:
  void go(std::array<std::size_t, 2> at, std::array<bool, 2> above, std::vector<Crossing> open,
          Arcs arcs) {
    if (above[0] && !above[1]) return;
    if (at[0] == ways_[0].size() && at[1] == ways_[1].size()) {
      if (open.empty() && above[0] == end_) found_.insert(arcs);
      return;
    }
    for (std::size_t w = 0; w < 2; ++w) {
      if (at[w] == ways_[w].size()) continue;
      auto next_at = at;
      auto next_above = above;
      auto next_open = open;
      auto next_arcs = arcs;
      next_open.push_back(ways_[w][next_at[w]++]);
      next_above[w] = !next_above[w];
      if (next_open.size() == 2) {
        next_arcs.insert(std::set(next_open.begin(), next_open.end()));
        next_open.clear();
      }
      go(next_at, next_above, next_open, next_arcs);
    }
  }

  std::array<std::vector<Crossing>, 2> ways_;  ///< where lines enter, and where they leave
  bool end_;
  std::set<Arcs> found_;
};

/// The numbers of crossings are given, not those of the field: what the face makes of them depends on
/// the sides of its corners and on the direction only.
TEST(CheckerTopology, PairedArcsAreThoseOfAllOrders) {
  std::mt19937_64 random(21);
  const auto upto = [&](int most) {
    return static_cast<int>(random() % (2 * static_cast<unsigned>(most) + 1)) - most;
  };
  std::set<std::array<int, 4>> kinds;
  std::map<std::size_t, int> paired, refused;
  for (int trial = 0; trial < 4000; ++trial) {
    const Level level(upto(8), 10);
    GivenTensors tensors;
    std::array<Tensor<Ball>, 3> balls;
    std::array<Corner, 3> corners;
    bool is_zero = false;
    const int size = 1 + trial % 5;
    for (std::uint32_t i = 0; i < 3; ++i) {
      auto& m = tensors.all[i];
      for (const std::size_t k : {0U, 1U, 3U, 4U, 5U}) m[k] = upto(size);
      m[2] = -m[0] - m[1];
      is_zero = is_zero || trace(m, m) == 0;
      if (is_zero) break;
      corners[i] = {&balls[i], 0, &tensors, i};
      balls[i] = enclosure(m, corners[i].shift);
      corners[i].above = level.above(corners[i]);
    }
    if (is_zero) continue;
    const auto proved = level.prove(corners);
    if (proved.proof != Proof::monotone) continue;
    const auto rises = [&](std::size_t i) { return proved.direction[i % 3] > 0; };
    std::size_t apex = 0;
    while (rises(apex) == rises(apex + 1) || rises(apex) == rises(apex + 2)) ++apex;
    const std::size_t first = (apex + 1) % 3, last = (apex + 2) % 3;
    const std::vector<std::size_t> base{first, last}, over{first, apex, last};
    if (!kinds.insert({static_cast<int>(apex), rises(apex) ? 1 : 0,
                       4 * corners[0].above + 2 * corners[1].above + corners[2].above,
                       std::count(proved.direction.begin(), proved.direction.end(), 0) > 0})
             .second)
      continue;
    for (unsigned code = 0; code < 216; ++code) {
      const std::map<std::array<std::size_t, 2>, unsigned> counts{
          {{{0, 1}}, code % 6}, {{{0, 2}}, code / 6 % 6}, {{{1, 2}}, code / 36}};
      unsigned all = 0;
      bool fits = true;
      for (const auto& [edge, n] : counts) {
        all += n;
        fits = fits && (n % 2 == 1) == (corners[edge[0]].above != corners[edge[1]].above);
      }
      if (!fits || all == 0 || all > 8) continue;
      // A line enters where the weight of a corner with a positive entry is 0.
      std::array ways{along(base, counts), along(over, counts)};
      if (!rises(apex)) std::swap(ways[0], ways[1]);
      const Orders orders(ways, corners[first].above, corners[last].above);
      const std::array<EdgeLevel, 3> edges{{{true, counts.at({0U, 1U}), {}},
                                            {true, counts.at({0U, 2U}), {}},
                                            {true, counts.at({1U, 2U}), {}}}};
      const FaceLevel face = level_in_face(level, corners, {&edges[0], &edges[1], &edges[2]});
      if (!face.decided || face.refinement != nullptr) {
        if (orders.found().empty()) continue;
        EXPECT_GT(all, 4u) << "two arcs are always forced";
        ++refused[all / 2];
        continue;
      }
      ASSERT_EQ(orders.found().size(), 1u) << "trial " << trial << ", code " << code;
      Arcs arcs;
      for (const auto& arc : face.arcs) arcs.insert(std::set(arc.begin(), arc.end()));
      EXPECT_EQ(arcs, *orders.found().begin()) << "trial " << trial << ", code " << code;
      ++paired[all / 2];
    }
  }
  std::cout << kinds.size() << " kinds of faces; faces with n arcs, paired and cut:";
  for (std::size_t n = 1; n <= 4; ++n) std::cout << ' ' << paired[n] << '/' << refused[n];
  std::cout << '\n';
  EXPECT_GE(kinds.size(), 36u);
  EXPECT_GT(paired[1], 30);
  EXPECT_GT(paired[2], 30);
  EXPECT_GT(paired[3], 30);
  EXPECT_GT(refused[3], 10);
}

}  // namespace
}  // namespace certificate
