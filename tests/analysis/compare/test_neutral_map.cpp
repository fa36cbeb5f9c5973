// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "baselines/edge_roots.hpp"
#include "baselines/neutral_map.hpp"

namespace tensortopo::baselines {
namespace {

class NeutralMaps : public testing::Test {
 protected:
  double number() { return normal_(random_); }
  Vector3<double> vector() { return {number(), number(), number()}; }
  Deviator<double> tensor() { return {number(), number(), number(), number(), number()}; }
  std::array<Deviator<double>, 4> tensors() { return {tensor(), tensor(), tensor(), tensor()}; }

  std::mt19937_64 random_{20241229};
  std::normal_distribution<double> normal_;
};

TEST_F(NeutralMaps, TheTensorAtTheWeightsOfADirectionAnnihilatesIt) {
  for (int trial = 0; trial < 100; ++trial) {
    const auto t = tensors();
    const auto v = vector();
    const auto b = NeutralMap(t).weights(v);
    const auto sum = b[0] * t[0] + b[1] * t[1] + b[2] * t[2] + b[3] * t[3];
    const auto image = thrice(sum) * v;
    EXPECT_LT(dot(image, image), 1e-20 * norm_form(sum) * dot(v, v));
  }
}

TEST_F(NeutralMaps, TheHalvesOfACubicAreItsCubicsOnTheHalves) {
  for (int trial = 0; trial < 20; ++trial) {
    const NeutralMap map(tensors());
    const auto a = vector(), b = vector(), c = vector(), m = 0.5 * (a + b);
    const auto whole = map.on({a, b, c}), first = map.on({c, a, m}), second = map.on({b, c, m}),
               named_otherwise = map.on({b, c, a});
    const auto centre = map.weights((1.0 / 3) * (a + b + c));
    for (std::size_t i = 0; i < 4; ++i) {
      const auto parts = halves(whole[i]);
      const auto same = turned(whole[i]);
      double sum = 0;
      for (std::size_t k = 0; k < 10; ++k) {
        EXPECT_NEAR(parts[0][k], first[i][k], 1e-11);
        EXPECT_NEAR(parts[1][k], second[i][k], 1e-11);
        EXPECT_NEAR(same[k], named_otherwise[i][k], 1e-11);
        const bool corner = k == cubic_place(0, 0) || k == cubic_place(3, 0) ||
                            k == cubic_place(0, 3);
        sum += (corner ? 1 : k == cubic_place(1, 1) ? 6 : 3) * whole[i][k] / 27;
      }
      EXPECT_NEAR(sum, centre[i], 1e-11);
    }
  }
}

TEST_F(NeutralMaps, SlopesAreDifferenceQuotientsOfTheWeights) {
  const NeutralMap map(tensors());
  const auto v = vector(), d = vector();
  const auto slopes = map.slopes(v, d);
  const double h = 1e-5;
  const auto up = map.weights(v + h * d), down = map.weights(v - h * d);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(slopes[i], (up[i] - down[i]) / (2 * h), 1e-6);
}

TEST_F(NeutralMaps, NeutralPointsOfAnEdgeAreTheSameFromEitherEndAndNeutral) {
  std::size_t found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const FieldPoint p{tensor(), vector()}, q{tensor(), vector()};
    const auto places = neutral_points(p, q);
    EXPECT_EQ(places, neutral_points(q, p));
    EXPECT_EQ(places.size() % 2 == 1,
              (determinant_form(p.tensor) > 0) != (determinant_form(q.tensor) > 0));
    for (const auto& x : places) {
      const double t = (x.x - p.position.x) / (q.position.x - p.position.x);
      EXPECT_NEAR(determinant_form(p.tensor + t * (q.tensor - p.tensor)), 0, 1e-9);
      ++found;
    }
  }
  EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace tensortopo::baselines
