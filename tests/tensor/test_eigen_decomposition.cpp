// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
Scalar distance(const Vector3<Scalar>& u, const Vector3<Scalar>& v) {
  using std::sqrt;
  return sqrt(dot(u - v, u - v));
}

template <class Scalar>
void is_an_eigensystem(const SymmetricTensor<Scalar>& t, int ulps) {
  using std::abs;
  using std::sqrt;
  const auto [values, vectors] = eigen_decomposition(t);
  const Scalar size = sqrt(inner(t, t));
  const Scalar unit = Scalar(ulps) * std::numeric_limits<Scalar>::epsilon();
  ASSERT_GE(values[0], values[1]);
  ASSERT_GE(values[1], values[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_LE(distance(t * vectors[i], values[i] * vectors[i]), unit * size);
    for (std::size_t j = 0; j < 3; ++j)
      ASSERT_LE(abs(Scalar(dot(vectors[i], vectors[j]) - Scalar(i == j))), unit);
  }
  ASSERT_LE(distance(cross(vectors[0], vectors[1]), vectors[2]), unit);
}

template <class Scalar>
class EigenDecompositionTest : public testing::Test {};
using Reals = testing::Types<double, Real50, Real100>;
TYPED_TEST_SUITE(EigenDecompositionTest, Reals);

template <class Scalar>
SymmetricTensor<Scalar> tensor(int xx, int yy, int zz, int xy, int yz, int xz) {
  return {Scalar(xx), Scalar(yy), Scalar(zz), Scalar(xy), Scalar(yz), Scalar(xz)};
}

TYPED_TEST(EigenDecompositionTest, SolvesRandomIntegerTensors) {
  rc::detail::checkGTest([] {
    int c[6];
    for (int& x : c) x = *rc::gen::inRange(-100, 101);
    is_an_eigensystem(tensor<TypeParam>(c[0], c[1], c[2], c[3], c[4], c[5]), 16);
    RC_ASSERT(!testing::Test::HasFailure());
  });
}

TYPED_TEST(EigenDecompositionTest, SolvesDegenerateAndSpecialTensors) {
  using Scalar = TypeParam;
  is_an_eigensystem(tensor<Scalar>(0, 0, 0, 0, 0, 0), 8);
  is_an_eigensystem(tensor<Scalar>(1, 1, 1, 0, 0, 0), 8);
  is_an_eigensystem(tensor<Scalar>(0, 0, 0, 1, 1, 1), 8);
  is_an_eigensystem(tensor<Scalar>(0, 0, 0, 0, 0, 7), 8);
  is_an_eigensystem(tensor<Scalar>(-1, -4, -9, 2, 6, 3), 8);
}

TEST(EigenDecomposition, SurvivesExtremeScales) {
  for (const double scale : {1e-300, 1e-160, 1e150, 1e300})
    is_an_eigensystem(SymmetricTensor<double>{scale, -3 * scale, 2 * scale, scale, scale, scale},
                      8);
}

TEST(EigenDecomposition, OfADiagonalTensorIsExact) {
  const auto [values, vectors] = eigen_decomposition(SymmetricTensor<double>{-13, 2, 11, 0, 0, 0});
  EXPECT_EQ(values, (std::array<double, 3>{11, 2, -13}));
  EXPECT_EQ(vectors[0], (Vector3<double>{0, 0, 1}));
  EXPECT_EQ(vectors[1], (Vector3<double>{0, 1, 0}));
  EXPECT_EQ(vectors[2], (Vector3<double>{-1, 0, 0}));
}

TEST(EigenDecomposition, DoubleAgreesWithFiftyDigits) {
  const auto coarse = eigen_decomposition(SymmetricTensor<double>{1, -5, 4, 2, -3, 7});
  const auto fine = eigen_decomposition(SymmetricTensor<Real50>{1, -5, 4, 2, -3, 7});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(coarse.values[i], static_cast<double>(fine.values[i]), 4e-15);
}

}  // namespace
}  // namespace tensortopo
