// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What the checker spends on a level for which no proof closes.
#include <gtest/gtest.h>

#include <random>

#include "run/work_limit.hpp"
#include "topology.hpp"

namespace certificate {
namespace {

/// The tensor [[1, s, 0], [s, 0, 0], [0, 0, -1]], of determinant s^2, times a factor.
std::array<double, 6> tangent(double s, double factor) {
  return {factor, 0, -factor, factor * s, 0, 0};
}

/// Where s changes its sign, mode 0 touches an edge from one side, at no place where edges are cut:
/// proofs close everywhere else, in ever smaller parts.
TEST(CheckerBudget, OfALevelThatTouchesEdges) {
  const ForAll for_all = [](std::size_t count, const std::function<void(std::size_t)>& f,
                            const char*) {
    for (std::size_t i = 0; i < count; ++i) f(i);
  };
  constexpr double kLong = 5559060566555523;  // 3^33, of 53 bits
  std::size_t undecided = 0, asked = 0;
  for (const double factor : {1.0, 1 / 3.0, kLong, 0x1p-900 / 7})
    for (const double end : {2.0, 3.0, 1 / 3.0, 0x1p-20}) {
      Input input;
      input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      input.tensors = {tangent(-1, factor), tangent(-2, factor),
                       {3 * factor, factor, -4 * factor, 2 * factor, 5 * factor, factor},
                       tangent(end, factor)};
      input.tets = {{0, 1, 2, 3}};
      input.cells = {0};
      const Level level(0, 1);
      const Field field(input, level.multiples(), for_all);
      const Topology topology = derive_topology(input, field, level, {false}, for_all, for_all);
      for (const EdgeTopology& edge : topology.edges) if (!edge.is_decided()) ++undecided;
      asked += level.decided_exactly();
      EXPECT_LT(level.decided_exactly(), 3000u) << factor << ' ' << end;
    }
  EXPECT_GE(undecided, 16u);
  EXPECT_GT(asked, 1000u);
}

/// Tensors of mode 0, 1 and -1 on one edge, which is the longest: inside tubes that the level is
/// not next to, shorter edges do not count as longer, so that it is cut, and proofs close.
TEST(CheckerBudget, OfEdgesThatPassModesOneAndMinusOne) {
  std::mt19937_64 random(35);
  std::normal_distribution<double> normal;
  std::size_t crossed = 0;
  for (const int numerator : {1, -1, 0})
    for (const double noise : {0.0, 0.0003, 0.001, 0.003, 0.005})
      for (int round = 0; round < 8; ++round) {
        Input input;
        input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        input.tensors = {{1, -1, 0, 0, 0, 0}, {-1, 0, 0, 0, 0, 0}, {-1, 0, 0, 0, 0, 0}, {}};
        for (double& x : input.tensors[3]) x = normal(random);
        for (auto& tensor : input.tensors)
          for (double& x : tensor) x += noise * normal(random);
        input.tets = {{0, 1, 2, 3}};
        input.cells = {0};
        const Level level(numerator, 2);
        const Field field(input, level.multiples(), in_parallel({}));
        const Topology topology =
            derive_topology(input, field, level, {false}, in_parallel({}), in_parallel({}));
        for (const TetTopology& tet : topology.tets) {
          EXPECT_TRUE(tet.is_decided()) << numerator << "/2, " << noise << ", round " << round;
          crossed += tet.is_crossed() ? 1u : 0u;
        }
      }
  EXPECT_GT(crossed, 80u);
}

/// Many such tetrahedra take as much as the limit says, and then some that are decided together;
/// what is left out is undecided, and always the same.
TEST(CheckerBudget, OfManyTetrahedra) {
  constexpr std::uint64_t kLimit = 20000;
  Input input;
  for (Vertex copy = 0; copy < 1000; ++copy) {
    for (const std::array<double, 3>& p :
         {std::array<double, 3>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      input.points.push_back(p);
    input.tensors.insert(input.tensors.end(),
                         {tangent(-1, 1), tangent(-2, 1), {3, 1, -4, 2, 5, 1}, tangent(2, 1)});
    input.tets.push_back({4 * copy, 4 * copy + 1, 4 * copy + 2, 4 * copy + 3});
    input.cells.push_back(copy);
  }
  const auto derive = [&](WorkLimit limit) {
    const Level level(0, 1);
    const Field field(input, level.multiples(), in_parallel({}));
    const Topology topology =
        derive_topology(input, field, level, std::vector<bool>(input.tets.size()), in_parallel({}),
                        limit.within(level, {}));
    EXPECT_TRUE(limit.is_reached());
    EXPECT_LT(level.decided_by_balls() + level.decided_exactly(), 20 * kLimit);
    std::vector<bool> decided;
    for (const TetTopology& tet : topology.tets) decided.push_back(tet.is_decided());
    for (const EdgeTopology& edge : topology.edges) decided.push_back(edge.is_decided());
    return decided;
  };
  const auto once = derive(WorkLimit(kLimit)), again = derive(WorkLimit(kLimit));
  EXPECT_EQ(once, again);
  EXPECT_GT(std::count(once.begin(), once.end(), true), 20);
  EXPECT_GT(std::count(once.begin(), once.end(), false), 2000);
}

}  // namespace
}  // namespace certificate
