// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/compared.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "witness.hpp"

namespace tensortopo {
namespace {

using Tensors = std::array<SymmetricTensor<double>, 4>;

SymmetricTensor<double> random_tensor(int size) {
  double c[6];
  for (double& x : c) x = *rc::gen::inRange(-size, size + 1);
  return {c[0], c[1], c[2], c[3], c[4], c[5]};
}

int rational_rank(const Tensors& t) {
  return field_rank(TetrahedronField<Rational>{
      {deviator(tensor_cast<Rational>(t[0])), deviator(tensor_cast<Rational>(t[1])),
       deviator(tensor_cast<Rational>(t[2])), deviator(tensor_cast<Rational>(t[3]))}});
}

TEST(Rank, OfEachWitnessFieldIsAsNamed) {
  for (const auto& f : witness::all) {
    EXPECT_EQ(field_rank(witness::unit_tetrahedron<Rational>(f)), f.rank) << f.name;
    EXPECT_EQ(exact_rank(witness::unit_tetrahedron_tensors<double>(f)), f.rank) << f.name;
  }
}

TEST(Rank, IsAtMostThreeWithAZeroVertex) {
  Tensors t = witness::unit_tetrahedron_tensors<double>(witness::generic_1);
  EXPECT_EQ(exact_rank(t), 4);
  t[2] = {7, 7, 7, 0, 0, 0};
  EXPECT_EQ(exact_rank(t), 3);
}

RC_GTEST_PROP(Rank, OfDoublesIsTheRankOfTheSameRationals, ()) {
  // Small entries and many exact dependencies, so that all ranks occur.
  const Tensors t = {random_tensor(1), random_tensor(1), random_tensor(1), random_tensor(1)};
  RC_CLASSIFY(rational_rank(t) < 4);
  RC_ASSERT(exact_rank(t) == rational_rank(t));
}

RC_GTEST_PROP(Rank, OfACombinationOfThreeIsAtMostThreeUntilOneUlpIsAdded, ()) {
  // Thirty bits each: sums are exact, but minors in doubles are not, and come out as noise.
  constexpr int size = 1 << 29;
  const auto a = random_tensor(size), b = random_tensor(size), c = random_tensor(size);
  const double k = *rc::gen::inRange(-9, 10), l = *rc::gen::inRange(-9, 10);
  Tensors t = {a, b, c, k * a + l * b + c};
  RC_ASSERT(exact_rank(t) <= 3);
  RC_ASSERT(exact_rank(t) == rational_rank(t));
  t[3].xy = std::nextafter(t[3].xy, std::numeric_limits<double>::infinity());
  RC_ASSERT(exact_rank(t) == rational_rank(t));
}

TEST(Rank, SeesOneUlpThatNoFloatingFilterCan) {
  Tensors t = witness::unit_tetrahedron_tensors<double>(witness::generic_1);
  t[3] = t[0] + t[1] + t[2];
  EXPECT_EQ(exact_rank(t), 3);
  t[3].yz = std::nextafter(t[3].yz, 100.0);
  EXPECT_EQ(exact_rank(t), 4);
}

TEST(Rank, DoesNotDependOnTheScale) {
  test::Compared compared("ranks", 20);
  for (const auto& f : witness::all) {
    if (f.rank < 4 && f.denominator[0] != 1) continue;
    for (const double scale : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000}) {
      Tensors t = witness::unit_tetrahedron_tensors<double>(f);
      for (auto& x : t) x = scale * x;
      ++compared;
      EXPECT_EQ(exact_rank(t), f.rank) << f.name << ' ' << scale;
    }
  }
}

TEST(Rank, SurvivesVerticesOfVeryDifferentScale) {
  Tensors t = witness::unit_tetrahedron_tensors<double>(witness::generic_1);
  t[0] = 0x1p900 * t[0];
  t[1] = 0x1p-900 * t[1];
  EXPECT_EQ(exact_rank(t), 4);
}

TEST(Rank, RefusesWhatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    Tensors t = witness::unit_tetrahedron_tensors<double>(witness::generic_1);
    t[1].yz = bad;
    EXPECT_THROW(exact_rank(t), std::invalid_argument);
  }
}

TEST(Rank, OfAFaceHasThreeTensors) {
  const auto t = witness::unit_tetrahedron_tensors<double>(witness::rank2);
  EXPECT_EQ(exact_rank(std::span<const SymmetricTensor<double>>(t.data(), 3)), 2);
  EXPECT_EQ(exact_rank(std::span<const SymmetricTensor<double>>(t.data(), 1)), 1);
}

}  // namespace
}  // namespace tensortopo
