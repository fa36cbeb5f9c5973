// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/face_curves.hpp"
#include "support/compared.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "extract/cases/extract_case.hpp"
#include "support/oracles/brute_force.hpp"

namespace tensortopo::test {
namespace {

using FaceCase = SimplexCase<double, 3>;

struct Curves {
  explicit Curves(const FaceCase& face) {
    constexpr std::array<std::array<std::size_t, 2>, 3> ends{{{0, 1}, {0, 2}, {1, 2}}};
    for (std::size_t e = 0; e < 3; ++e) {
      const auto found = edge_crossings(face.edge(ends[e][0], ends[e][1]), face.level);
      if (!found) return;
      crossings[e] = *found;
    }
    const std::array<std::span<const EdgeCrossing<double>>, 3> spans{crossings[0], crossings[1],
                                                                     crossings[2]};
    arcs = face_curves(face.simplex, spans, face.level, Sampling{});
  }

  FaceTopology topology() const {
    FaceTopology result;
    for (std::size_t e = 0; e < 3; ++e)
      result.edge_crossings[e] = static_cast<int>(crossings[e].size());
    for (const auto& arc : *arcs) ++(arc.closed ? result.closed_loops : result.open_arcs);
    return result;
  }

  std::array<std::vector<EdgeCrossing<double>>, 3> crossings;
  std::optional<std::vector<FaceArc<double>>> arcs;
};

// Where an arc begins or ends, in the triangle.
std::array<double, 3> weights_of(const ArcEnd& end, const Curves& curves) {
  constexpr std::array<std::array<std::size_t, 2>, 3> ends{{{0, 1}, {0, 2}, {1, 2}}};
  const auto e = static_cast<std::size_t>(end.edge);
  const double w = curves.crossings[e][static_cast<std::size_t>(end.crossing)].weight;
  std::array<double, 3> weights{0, 0, 0};
  weights[ends[e][0]] = 1 - w, weights[ends[e][1]] = w;
  return weights;
}

double mode_at(const FaceCase& face, const std::array<double, 3>& weights) {
  const auto t = tensor_at(face.simplex.tensors, weights);
  const double p = norm_form(t);
  return std::sqrt(2.0) * determinant_form(t) / (p * std::sqrt(p));
}

TEST(PlanarWitness, HasTheArcsAndLoopsStated) {
  Compared compared("levels of witnesses", 10);
  for (const auto& witness : planar_witnesses())
    for (const auto& curve : witness.curves) {
      SCOPED_TRACE(witness.name + " at " + mode_of(curve.mode).text());
      const FaceCase face(witness.corners(), mode_of(curve.mode));
      const Curves curves(face);
      if (curve.tangent && !curves.arcs) continue;  // a touch is no crossing: no proof may close
      ASSERT_TRUE(curves.arcs);
      ++compared;
      EXPECT_EQ(curves.topology().closed_loops, curve.closed_loops);
      EXPECT_EQ(curves.topology().open_arcs, curve.open_arcs);
    }
}

TEST(FaceCurves, AreWhatBruteForceSeesOnRandomTriangles) {
  const std::uint64_t seed = 20240201;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int decided = 0;
  const int count = trials(400);
  for (int trial = 0; trial < count; ++trial) {
    const std::array<SymmetricTensor<double>, 3> tensors{random.tensor(), random.tensor(),
                                                         random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % 8]);
    SCOPED_TRACE("trial " + std::to_string(trial) + " mode " + mode.text());
    const Curves curves(FaceCase(tensors, mode));
    ASSERT_TRUE(curves.arcs);
    const auto expected = brute_force_face_topology(corners_of(tensors), mode.approx());
    if (!expected) continue;
    ++decided;
    EXPECT_EQ(curves.topology(), *expected);
  }
  std::cout << "brute force decided " << decided << " of " << count << '\n';
  EXPECT_GT(10 * decided, 8 * count);
}

// Samples, ends included, lie on the level, in order, close enough together for the field to turn
// little, and the larger mode lies to the left of the polyline.
TEST(FaceCurves, PolylinesFollowTheLevelWithTheLargerModeOnTheLeft) {
  const std::uint64_t seed = 20240202;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int steps = 0, on_the_left = 0;
  for (int trial = 0; trial < trials(400, 200); ++trial) {
    const std::array<SymmetricTensor<double>, 3> tensors{random.tensor(), random.tensor(),
                                                         random.tensor()};
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    SCOPED_TRACE("trial " + std::to_string(trial) + " mode " + mode.text());
    const FaceCase face(tensors, mode);
    const Curves curves(face);
    ASSERT_TRUE(curves.arcs);
    for (const auto& arc : *curves.arcs) {
      std::vector<std::array<double, 3>> line;
      if (!arc.closed) line.push_back(weights_of(arc.begin, curves));
      double last = -1;
      for (const auto& sample : arc.samples) {
        EXPECT_GT(sample.place, last);
        last = sample.place;
        line.push_back(sample.weights);
        EXPECT_NEAR(sample.weights[0] + sample.weights[1] + sample.weights[2], 1, 1e-14);
        EXPECT_NEAR(dot(sample.medium, sample.medium), 1, 1e-13);
      }
      if (!arc.closed) line.push_back(weights_of(arc.end, curves));
      if (arc.closed) {
        EXPECT_GE(line.size(), 3u);
        line.push_back(line.front());
      } else if (arc.begin.edge == arc.end.edge) {
        EXPECT_GE(line.size(), 3u);
      }
      for (const auto& weights : line) {
        EXPECT_NEAR(mode_at(face, weights), mode.approx(), 1e-11);
        for (const double w : weights) EXPECT_GE(w, 0);
      }
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        // In the chart where the triangle's vertices are (0,0), (1,0), (0,1).
        const double u = line[i + 1][1] - line[i][1], v = line[i + 1][2] - line[i][2];
        const double step = 1e-3;
        const double x = (line[i][1] + line[i + 1][1]) / 2, y = (line[i][2] + line[i + 1][2]) / 2;
        const auto beside = [&](double k) {
          return mode_at(face, {1 - (x - k * v) - (y + k * u), x - k * v, y + k * u});
        };
        ++steps;
        on_the_left += beside(step) > beside(-step);
      }
    }
  }
  EXPECT_GT(steps, 1000);
  // Chords may cut a corner where the curve turns sharply.
  EXPECT_GT(on_the_left, steps - steps / 200);
}

TEST(FaceCurves, PointsOnArcsAreFoundAgain) {
  const std::uint64_t seed = 20240203;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(200); ++trial) {
    const std::array<SymmetricTensor<double>, 3> tensors{random.tensor(), random.tensor(),
                                                         random.tensor()};
    const FaceCase face(tensors, ModeValue::parse("-1/2"));
    const Curves curves(face);
    ASSERT_TRUE(curves.arcs);
    for (std::size_t a = 0; a < curves.arcs->size(); ++a) {
      const auto& arc = (*curves.arcs)[a];
      const double place = random.uniform() * static_cast<double>(arc.pieces.size());
      const auto point = point_on_arc(arc, face.simplex.tensors, place, face.level);
      EXPECT_NEAR(mode_at(face, point.weights), -0.5, 1e-11);
      const auto [found, where] = locate_on_arcs(std::span<const FaceArc<double>>(*curves.arcs),
                                                 face.simplex.tensors, point.weights, point.tensor);
      EXPECT_EQ(found, static_cast<int>(a));
      EXPECT_NEAR(where, place, 1e-6) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
