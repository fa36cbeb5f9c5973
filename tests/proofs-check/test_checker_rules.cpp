// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Rules of the checker's kernel that spare it to cut: tensors in reach of a corner, and arcs that
// crossings leave one way to join.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "topology.hpp"

namespace certificate {
namespace {

using Exact = Tensor<mpz_class>;

struct Tensors : ExactTensors {
  std::vector<Exact> all;
  Exact exact(std::uint32_t id) const override { return all[id]; }
};

/// Corners of a level with what they need to stay alive.
template <std::size_t V>
struct CornersOf {
  Tensors tensors;
  std::array<Tensor<Ball>, V> balls;
  std::array<Corner, V> corners;

  CornersOf(const Level& level, const std::array<Exact, V>& given, bool with_reach) {
    tensors.all.assign(given.begin(), given.end());
    for (std::uint32_t i = 0; i < V; ++i) {
      corners[i] = {&balls[i], 0, &tensors, i};
      balls[i] = enclosure(given[i], corners[i].shift);
      corners[i].above = level.above(corners[i]);
      if (with_reach) corners[i].reach = level.reach(corners[i]);
    }
  }
};

bool lies_above(const Level& level, const Exact& m) {
  return CornersOf<1>(level, std::array<Exact, 1>{m}, false).corners[0].above;
}

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  int upto(int most) {
    return static_cast<int>(random_() % (2 * static_cast<unsigned>(most) + 1)) - most;
  }
  /// Trace-free, of entries up to this.
  Exact tensor(int most) {
    Exact m;
    for (const std::size_t k : {0U, 1U, 3U, 4U, 5U}) m[k] = upto(most);
    m[2] = -m[0] - m[1];
    return m;
  }

 private:
  std::mt19937_64 random_;
};

/// Is tr(M T) > h |T|, for the enclosed M = exact / 2^shift?
bool is_in_reach(const Exact& m, const mpq_class& h, const Exact& t) {
  const mpz_class x = trace(m, t);
  return x > 0 && mpq_class(x * x) > h * h * mpq_class(trace(t, t));
}

mpq_class reach_of(const Corner& corner) {
  mpq_class h(corner.reach);
  h *= mpq_class(mpz_class(1) << static_cast<unsigned long>(corner.shift));
  return h;
}

/// Tensors of the other side are out of reach, those with the same eigenvectors next to the level
/// too; such tensors of the corner's side are in reach, but for those next to the level.
TEST(CheckerArithmetic, TensorsInReachAreOnTheSide) {
  Numbers numbers(11);
  int near = 0, in = 0, out = 0, none = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const int kind = trial % 4;
    const int top = kind == 0 ? 0 : kind == 1 ? 999 - 1998 * (trial / 4 % 2) : numbers.upto(990);
    const Level level(top, 1000);
    Exact m = numbers.tensor(1000);
    if (trace(m, m) == 0) continue;
    if (kind == 3)
      for (const std::size_t k : {3U, 4U, 5U}) m[k] = 0;
    const CornersOf<1> at(level, std::array<Exact, 1>{m}, true);
    const Corner& corner = at.corners[0];
    if (!(corner.reach < HUGE_VAL)) {
      ++none;
      continue;
    }
    const mpq_class h = reach_of(corner);
    for (int other = 0; other < 20; ++other) {
      Exact t = m;
      const int spread = std::array{30, 200, 1000}[static_cast<std::size_t>(other) % 3];
      const Exact change = numbers.tensor(spread);
      for (std::size_t k = 0; k < 6; ++k)
        if (kind != 3 || k < 3) t[k] += change[k];
      if (other % 7 == 6)
        for (mpz_class& x : t) x = -x;
      if (trace(t, t) == 0) continue;
      if (is_in_reach(m, h, t)) {
        ++in;
        ASSERT_EQ(lies_above(level, t), corner.above) << "trial " << trial;
      } else {
        ++out;
      }
      if (kind != 3) continue;
      // On the way to a diagonal tensor of the other side: places next to the level.
      if (lies_above(level, t) == corner.above) continue;
      Exact low = m, high = t;
      for (int step = 0; step < 30; ++step) {
        Exact middle;
        for (std::size_t k = 0; k < 6; ++k) middle[k] = low[k] + high[k];
        const bool is_low = lies_above(level, middle) == corner.above;
        (is_low ? low : high) = middle;
        for (mpz_class& x : is_low ? high : low) x *= 2;
      }
      ASSERT_FALSE(is_in_reach(m, h, high)) << "trial " << trial;
      ++near;
    }
  }
  EXPECT_GT(near, 300);
  EXPECT_GT(in, 10000);
  EXPECT_GT(out, 10000);
  EXPECT_LT(none, 100);
}

/// What is between corners in reach of one is on their side; opposite tensors are not in reach.
TEST(CheckerArithmetic, SimplicesInReachAreOnTheSide) {
  Numbers numbers(12);
  int empty = 0, same = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Level level(numbers.upto(900), 1000);
    const Exact middle = numbers.tensor(1000);
    std::array<Exact, 4> tensors;
    for (Exact& t : tensors) {
      t = numbers.tensor(std::array{50, 300, 900}[static_cast<std::size_t>(trial) % 3]);
      const int sign = trial % 5 == 0 && numbers.upto(1) < 0 ? -1 : 1;
      for (std::size_t k = 0; k < 6; ++k) t[k] += sign * middle[k];
    }
    const CornersOf<4> s(level, tensors, true), without(level, tensors, false);
    const bool is_empty = level.prove(s.corners).proof == Proof::empty;
    same += is_empty == (level.prove(without.corners).proof == Proof::empty);
    if (!is_empty) continue;
    ++empty;
    for (int place = 0; place < 30; ++place) {
      Exact m;
      for (const Exact& t : tensors) {
        const int weight = std::max(0, numbers.upto(4));
        for (std::size_t k = 0; k < 6; ++k) m[k] += weight * t[k];
      }
      if (trace(m, m) == 0) continue;
      ASSERT_EQ(lies_above(level, m), s.corners[0].above) << "trial " << trial;
    }
  }
  EXPECT_GT(empty, 1000);
  EXPECT_GT(same, 3900);
}

/// The reach of a corner is believed, and exactly compared: on an edge between tensors of one side
/// that passes the level twice, a number that is too small by little claims the other side away.
TEST(CheckerArithmetic, ReachIsComparedWithEachCorner) {
  const Level level(9, 10);
  const Exact m{1, 0, -1}, t{3, -2, -1}, opposite{-3, 2, 1};
  const double h = 4 / std::sqrt(14.0);  // tr(M T) / |T|
  const auto is_empty = [&](const Exact& second, double reach) {
    CornersOf<2> s(level, std::array<Exact, 2>{m, second}, false);
    s.corners[0].reach = std::ldexp(reach, static_cast<int>(-s.corners[0].shift));
    EXPECT_EQ(s.corners[0].above, s.corners[1].above);
    return level.prove(s.corners).proof == Proof::empty;
  };
  EXPECT_FALSE(is_empty(t, HUGE_VAL));
  EXPECT_FALSE(is_empty(t, h * (1 + 1e-9)));
  EXPECT_TRUE(is_empty(t, h * (1 - 1e-9)));
  EXPECT_FALSE(is_empty(opposite, h * (1 - 1e-9)));
}

/// Arcs that are paired by the order of crossings are those of the face cut to pieces.
TEST(CheckerTopology, PairedArcsAreThoseOfCutFaces) {
  Numbers numbers(13);
  std::map<std::size_t, int> paired;
  for (int trial = 0; trial < 12000; ++trial) {
    const int spread = std::array{3, 5, 9, 30}[static_cast<std::size_t>(trial) % 4];
    const Level level(trial % 5 == 0 ? 0 : numbers.upto(950), 1000);
    std::array<Exact, 3> tensors;
    for (Exact& t : tensors) t = numbers.tensor(spread);
    if (std::any_of(tensors.begin(), tensors.end(), [](auto& t) { return trace(t, t) == 0; }))
      continue;
    const CornersOf<3> s(level, tensors, false);
    const auto& [a, b, c] = s.corners;
    const std::array edges{level_in_edge(level, {a, b}), level_in_edge(level, {a, c}),
                           level_in_edge(level, {b, c})};
    const std::array<const EdgeLevel*, 3> at{&edges[0], &edges[1], &edges[2]};
    const FaceLevel face = level_in_face(level, s.corners, at);
    const FaceLevel fine = level_in_face(level, s.corners, at, true);
    if (!face.decided || !fine.decided || face.refinement) continue;
    ++paired[face.arcs.size()];
    auto arcs = face.arcs, expected = fine.arcs;
    std::sort(arcs.begin(), arcs.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(arcs, expected) << "trial " << trial;
    ASSERT_TRUE(fine.loops.empty()) << "trial " << trial;
  }
  EXPECT_GT(paired[1], 1000);
  EXPECT_GT(paired[2], 150);
}

const ForAll kEach = [](std::size_t count, const std::function<void(std::size_t)>& f,
                        const char*) {
  for (std::size_t i = 0; i < count; ++i) f(i);
};

Input one_tetrahedron(const std::vector<std::array<double, 6>>& tensors) {
  Input input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {{0, 1, 2, 3}};
  input.tensors = tensors;
  return input;
}

/// A convex body passes through two edges, or an edge and a face: its surface is one annulus. The
/// region outside is joined behind the body, where no corner is seen along the direction.
TEST(CheckerTopology, SurfacesOfBodiesInTwoFacesAreOneSheet) {
  struct Exhibit {
    Invariant invariant;
    int value;
    std::vector<std::array<double, 6>> tensors;
  };
  const std::vector<Exhibit> all{
      {Invariant::deviator_magnitude, 8,
       {{8, 3, 7, -2, -4, 8}, {-7, -7, 9, 3, 6, -7}, {5, -3, -4, -7, -8, -3},
        {-8, 0, 4, 9, 0, 9}}},
      {Invariant::deviator_magnitude, 3,
       {{-2, -3, 5, 5, 5, 2}, {2, 5, 0, -2, 4, -2}, {1, 0, 4, 2, 1, 2},
        {-1, -2, -10, -6, -11, -1}}},
      {Invariant::magnitude, 2,
       {{0, 1, 1, 1, -1, 0}, {-1, 0, 0, -2, -1, -1}, {-2, 2, 1, 1, 0, 2},
        {2, -2, -1, 2, -1, -1}}}};
  for (const auto& [invariant, value, tensors] : all) {
    const Input input = one_tetrahedron(tensors);
    const Level level(invariant, value);
    const Field field(input, level.multiples(), kEach);
    const Topology topology = derive_topology(input, field, level, {false}, kEach, kEach);
    ASSERT_EQ(topology.tets.size(), 1u);
    ASSERT_TRUE(topology.tets[0].decided);
    ASSERT_EQ(topology.tets[0].sheets.size(), 1u);
    EXPECT_EQ(topology.tets[0].sheets[0].euler_characteristic, 0);
    EXPECT_EQ(topology.tets[0].sheets[0].loops.size(), 2u);
  }
}

/// What a tetrahedron has does not depend on the order of its corners.
TEST(CheckerTopology, SheetsDoNotDependOnTheOrderOfCorners) {
  Numbers numbers(14);
  std::map<long, int> found;
  int open = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const int spread = std::array{4, 7, 30}[static_cast<std::size_t>(trial) % 3];
    const Level level(trial % 4 == 0 ? 0 : numbers.upto(900), 1000);
    Input input = one_tetrahedron(std::vector<std::array<double, 6>>(4));
    for (auto& t : input.tensors)
      for (double& x : t) x = numbers.upto(spread);
    std::array<std::vector<std::vector<long>>, 2> all;
    for (std::size_t order = 0; order < 2; ++order) {
      const Field field(input, level.multiples(), kEach);
      const Topology topology =
          derive_topology(input, field, level, {false}, kEach, kEach);
      for (const TetTopology& tet : topology.tets) {
        if (!tet.decided) all[order].push_back({-100});
        for (const MeshSheet& sheet : tet.sheets) {
          std::vector<long>& numbers_of = all[order].emplace_back();
          for (const MeshLoop& loop : sheet.loops)
            numbers_of.push_back(static_cast<long>(loop.steps.size()));
          std::sort(numbers_of.begin(), numbers_of.end());
          numbers_of.push_back(sheet.euler_characteristic);
          ++found[sheet.euler_characteristic];
        }
      }
      std::sort(all[order].begin(), all[order].end());
      std::rotate(input.tensors.begin(), input.tensors.begin() + 1 + trial % 3,
                  input.tensors.end());
    }
    const auto is_open = [](const auto& sheets) { return !sheets.empty() && sheets[0][0] == -100; };
    open += is_open(all[0]) || is_open(all[1]);
    if (is_open(all[0]) || is_open(all[1])) continue;
    ASSERT_EQ(all[0], all[1]) << "trial " << trial;
  }
  EXPECT_GT(found[1], 1500);
  EXPECT_GT(found[0], 100);
  EXPECT_LT(open, 3);
}

}  // namespace
}  // namespace certificate
