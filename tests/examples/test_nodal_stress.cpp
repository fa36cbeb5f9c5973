// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "calculix_files.hpp"
#include "nodal_stress.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

constexpr int kCornerSigns[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

// a + b sqrt(3) in integers.
struct Root3 {
  long a = 0, b = 0;
  friend Root3 operator*(Root3 u, Root3 v) {
    return {u.a * v.a + 3 * u.b * v.b, u.a * v.b + u.b * v.a};
  }
  friend Root3 operator+(Root3 u, Root3 v) { return {u.a + v.a, u.b + v.b}; }
  bool operator==(const Root3&) const = default;
};

// In integers: a monomial x^i y^j z^k, i, j, k in {0, 1}, has the value s / sqrt(3)^(i + j + k) at
// an integration point, and the weights give back its sign at each corner.
TEST(NodalStress, TheWeightsReproduceEveryTrilinearFunctionExactly) {
  for (unsigned monomial = 0; monomial < 8; ++monomial)
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Root3 sum, scale{4, 0};
      long expected = 1;
      for (int axis = 0; axis < 3; ++axis)
        if (monomial >> axis & 1)
          expected *= kCornerSigns[corner][axis], scale = scale * Root3{0, 1};
      for (unsigned point = 0; point < 8; ++point) {
        long sign = 1;
        for (int axis = 0; axis < 3; ++axis)
          if (monomial >> axis & 1) sign *= point >> axis & 1 ? 1 : -1;
        const auto weight = exact_weight(agreeing_signs(corner, point));
        sum = sum + Root3{sign * weight.rational, sign * weight.root3};
      }
      EXPECT_EQ(sum, (Root3{expected, 0} * scale));
    }
}

double largest_error(const HexMesh& mesh, Weights weights,
                     const std::function<SymmetricTensor<double>(const Vector3<double>&)>& stress) {
  const auto nodes = nodal_stress(mesh, sampled(mesh, stress), weights);
  double error = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto d = nodes[i] - stress(mesh.points[i]);
    for (const double x : {d.xx, d.yy, d.zz, d.xy, d.yz, d.xz})
      error = std::max(error, std::abs(x));
  }
  return error;
}

SymmetricTensor<double> linear(const Vector3<double>& p) {
  return {p.x + 2 * p.y - p.z + 1, p.y - 3, p.z, p.x - p.y, 5 - p.z, p.x + p.y + p.z};
}

TEST(NodalStress, ALinearStressComesBackOnEveryBlock) {
  for (const HexMesh& mesh :
       {box_mesh({3, 4, 5}, {9, 8, 7}), slab_mesh({6, 3, 2}, 1, {{9, 6, 4}, 3, 1, 0.4, 1})}) {
    EXPECT_LT(largest_error(mesh, Weights::exact, linear), 1e-13);
    // The weights of the .frd file do not do that, which is why the field does not come from there.
    EXPECT_GT(largest_error(mesh, Weights::calculix, linear), 1e-5);
  }
}

TEST(NodalStress, IsThePlainMeanOfTheHexahedraAtANode) {
  const HexMesh mesh = box_mesh({2, 1, 1}, {2, 1, 1});
  RestartFile::HexStress one, three;
  one.fill({1, 0, 0, 0, 0, 0});
  three.fill({3, 0, 0, 0, 0, 0});
  const auto nodes = nodal_stress(mesh, {one, three}, Weights::exact);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_NEAR(nodes[i].xx, 1 + mesh.points[i].x, 1e-14);
}

TEST(NodalStress, StressesOfAnotherMeshAreRefused) {
  EXPECT_THROW(nodal_stress(box_mesh({2, 1, 1}, {2, 1, 1}), {}, Weights::exact),
               std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
