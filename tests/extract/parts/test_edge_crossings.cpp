// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/edge_crossings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "extract/cases/exact_edge.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/oracles/brute_force.hpp"
#include "support/generators.hpp"
#include "support/oracles/level_sign.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

using Ends = std::array<SymmetricTensor<double>, 2>;

bool is_zero(const SymmetricTensor<double>& t) {
  return t.xx == t.yy && t.yy == t.zz && t.xy == 0 && t.yz == 0 && t.xz == 0;
}

// "" if the crossings are those of exact arithmetic.
template <class Scalar>
std::string differences(const Ends& ends, const ModeValue& mode,
                        const std::vector<ExactCrossing>& expected) {
  const SimplexCase<Scalar, 2> edge(ends, mode);
  const auto found = edge_crossings(edge.simplex, edge.level);
  if (!found) return "no proof";
  if (found->size() != expected.size())
    return std::to_string(found->size()) + " crossings instead of " +
           std::to_string(expected.size());
  bool above = edge.simplex.above[0];
  Scalar last(0);
  const int e0 = edge.simplex.exponents[0], e1 = edge.simplex.exponents[1];
  for (std::size_t k = 0; k < found->size(); ++k) {
    const auto& crossing = (*found)[k];
    if (crossing.rising == above) return "directions do not alternate from the first vertex on";
    above = !above;
    if (crossing.rising != expected[k].rising) return "a direction is wrong";
    if (crossing.weight < last) return "out of order";
    last = crossing.weight;
    // The weight refers to scaled tensors: back to the segment's own parameter.
    const double w = static_cast<double>(crossing.weight);
    const double far = std::ldexp(w, e1 - e0), t = far / (1 - w + far);
    if (t < expected[k].low - 1e-9 || t > expected[k].high + 1e-9)
      return "crossing " + std::to_string(k) + " at " + std::to_string(t) + " instead of " +
             std::to_string(expected[k].low);
  }
  return above == edge.simplex.above[1] ? "" : "the last direction contradicts the second vertex";
}

TEST(EdgeCrossings, AreTheRootsThatSturmCounts) {
  const std::uint64_t seed = 20240301;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::array<int, 7> histogram{};
  for (int trial = 0; trial < trials(4000); ++trial) {
    Ends ends{random.tensor(), random.tensor()};
    if (trial % 4 != 0)  // short numbers are faster
      for (auto& t : ends) t = rounded(t, 10);
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto exact = exact_crossings(ends[0], ends[1], mode);
    EXPECT_EQ(differences<double>(ends, mode, exact), "")
        << exact_text(ends[0]) << exact_text(ends[1]) << " at " << mode.text();
    ++histogram[exact.size()];
  }
  for (std::size_t n = 0; n < histogram.size(); ++n)
    std::cout << histogram[n] << " edges with " << n << " crossings\n";
  EXPECT_GT(histogram[2], 0);
  EXPECT_GT(histogram[3], 0);
}

TEST(EdgeCrossings, AreTheRootsThatSturmCountsAtFiftyDigitsToo) {
  const std::uint64_t seed = 20240302;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(200); ++trial) {
    const Ends ends{random.tensor(), random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    EXPECT_EQ(differences<Real50>(ends, mode, exact_crossings(ends[0], ends[1], mode)), "")
        << exact_text(ends[0]) << exact_text(ends[1]);
  }
}

// The oracle for tetrahedra counts them in another way.
TEST(EdgeCrossings, BothOraclesAgree) {
  const std::uint64_t seed = 20240303;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(600); ++trial) {
    const Ends ends{random.tensor(), random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto corners = corners_of(ends);
    EXPECT_EQ(exact_edge_crossings(LevelQuestion(corners, mode.approx()), 0, 1),
              static_cast<int>(exact_crossings(ends[0], ends[1], mode).size()));
  }
}

// Nearly degenerate: one end within 1e-3 ... 1e-12 of the other, of the level, of mode 1.
TEST(EdgeCrossings, AreTheRootsThatSturmCountsNextToTheLevel) {
  const std::uint64_t seed = 20240304;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int crossed = 0;
  for (int trial = 0; trial < trials(600, 300); ++trial) {
    // A tensor on the level up to rounding, from a crossing of a random edge.
    const Ends wide{random.tensor(), random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto crossings = exact_crossings(wide[0], wide[1], mode);
    if (crossings.empty()) continue;
    const double t = crossings[0].low;
    const auto on = (1 - t) * wide[0] + t * wide[1];
    const double size = std::ldexp(1.0, -3 * (trial % 14));
    const Ends ends{on + size * random.tensor(), on + size * random.tensor()};
    const auto exact = exact_crossings(ends[0], ends[1], mode);
    EXPECT_EQ(differences<double>(ends, mode, exact), "")
        << exact_text(ends[0]) << exact_text(ends[1]) << " at " << mode.text();
    crossed += !exact.empty();
  }
  EXPECT_GT(crossed, 25);
}

RC_GTEST_PROP(EdgeCrossings, OfSmallIntegersAreRightOrRefused, ()) {
  const Ends ends{*small_integer_tensor(3), *small_integer_tensor(3)};
  RC_PRE(!is_zero(ends[0]) && !is_zero(ends[1]));
  const auto mode = ModeValue::parse(std::to_string(*rc::gen::inRange(1, 999)) + "/1000");
  const SimplexCase<double, 2> edge(ends, mode);
  if (!edge_crossings(edge.simplex, edge.level)) return;  // a touch, or a zero between the ends
  RC_ASSERT(differences<double>(ends, mode, exact_crossings(ends[0], ends[1], mode)) == "");
}

TEST(EdgeCrossings, NeverRefuseAnEdgeInGeneralPosition) {
  const SimplexCase<double, 2> edge({{{3, 1, 2, 5, -1, 2}, {-1, 4, 2, 0, 3, 1}}},
                                    ModeValue::parse("1/2"));
  EXPECT_TRUE(edge_crossings(edge.simplex, edge.level));
}

TEST(EdgeCrossings, RefuseAnEdgeOnTheLevel) {
  const SymmetricTensor<double> t{11, 2, -13, 0, 0, 0};
  const SimplexCase<double, 2> edge({t, 3.0 * t}, ModeValue::parse("-143/343"));
  EXPECT_FALSE(edge_crossings(edge.simplex, edge.level));
}

// The opposite direction sees the same points from the other end.
TEST(EdgeCrossings, ReverseWithTheEdge) {
  const std::uint64_t seed = 20240305;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(300); ++trial) {
    const Ends ends{random.tensor(), random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const SimplexCase<double, 2> forth(ends, mode), back({ends[1], ends[0]}, mode);
    const auto f = edge_crossings(forth.simplex, forth.level),
               b = edge_crossings(back.simplex, back.level);
    ASSERT_TRUE(f && b);
    ASSERT_EQ(f->size(), b->size());
    for (std::size_t k = 0; k < f->size(); ++k) {
      const auto& other = (*b)[f->size() - 1 - k];
      EXPECT_NEAR((*f)[k].weight, 1 - other.weight, 1e-9);
      EXPECT_NE((*f)[k].rising, other.rising);
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
