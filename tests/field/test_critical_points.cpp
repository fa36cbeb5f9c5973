// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/fields/random_fields.hpp"
#include "support/fields/witness_fields.hpp"
#include "tensortopo/field/binary_cubic.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;

/// A critical point found otherwise, in 50 digits.
struct Known {
  Deviator<Real50> tensor;
  std::vector<Real50> weights;  ///< any sum
};

template <std::size_t Count>
std::vector<Tensor> list_of(const std::array<Tensor, Count>& t) {
  return {t.begin(), t.end()};
}

bool is_inside(const Known& k) {
  return std::all_of(k.weights.begin(), k.weights.end(), [](const Real50& w) { return w > 0; });
}

bool is_near_boundary(const Known& k) {
  return std::any_of(k.weights.begin(), k.weights.end(),
                     [](const Real50& w) { return abs(w) < 1e-9; });
}

// Where 2 P Q' = 3 Q P' along x a + y b.
std::vector<Known> known_on_edge(const std::array<Tensor, 2>& edge) {
  const auto a = deviator(tensor_cast<Real50>(edge[0])), b = deviator(tensor_cast<Real50>(edge[1]));
  const auto m = thrice(a), k = thrice(b);
  const Real50 p0 = norm_form(a), p1 = 2 * norm_form(a, b), p2 = norm_form(b);
  const Real50 q0 = determinant_form(a), q1 = inner(square(m), k), q2 = inner(square(k), m),
               q3 = determinant_form(b);
  std::vector<Known> known;
  for (auto [x, y] : binary_cubic_zeros<Real50>(
           {2 * p0 * q1 - 3 * p1 * q0, 4 * p0 * q2 - p1 * q1 - 6 * p2 * q0,
            6 * p0 * q3 + p1 * q2 - 4 * p2 * q1, 3 * p1 * q3 - 2 * p2 * q2})) {
    if (x + y < 0) x = -x, y = -y;
    known.push_back({x * a + y * b, {x, y}});
  }
  return known;
}

std::vector<Known> known_on_face(const std::array<Tensor, 3>& face) {
  const TriangleField<Real50> field{{deviator(tensor_cast<Real50>(face[0])),
                                     deviator(tensor_cast<Real50>(face[1])),
                                     deviator(tensor_cast<Real50>(face[2]))}};
  std::vector<Known> known;
  for (const auto& point : nondegenerate_critical_points(field))
    known.push_back({point.tensor, {point.weights.begin(), point.weights.end()}});
  return known;
}

// The tensor N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N or its opposite, N being orthogonal to all.
std::vector<Known> known_in_tet(const TetTensors& tensors) {
  using Field = TetrahedronField<Real50>;
  Field field;
  for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensor_cast<Real50>(tensors[i]));
  const auto n = characteristic_direction(field);
  const auto m = thrice(n);
  Known known;
  known.tensor = deviator(norm_form(n) * square(m) - determinant_form(n) * m);
  for (std::size_t i = 0; i < 4; ++i) {
    Field others = field;
    others.vertex[i] = n;
    const auto dual = characteristic_direction(others);
    known.weights.push_back(norm_form(known.tensor, dual) / norm_form(field.vertex[i], dual));
  }
  if (known.weights[0] < 0) {
    known.tensor = Real50(-1) * known.tensor;
    for (Real50& w : known.weights) w = -w;
  }
  Real50 largest = 0;
  for (const Real50& w : known.weights) largest = std::max(largest, Real50(abs(w)));
  for (Real50& w : known.weights) w /= largest;
  return {known};
}

/// Each known point inside is in one of those found, and there are no others.
template <class Points>
void compare(const std::vector<CriticalPoint>& found, Points known) {
  RC_PRE(std::none_of(known.begin(), known.end(), is_near_boundary));
  std::erase_if(known, [](const Known& k) { return !is_inside(k); });
  RC_ASSERT(found.size() == known.size());
  for (const Known& k : known) {
    Real50 sum = 0;
    for (const Real50& w : k.weights) sum += w;
    const Real50 value = mode(k.tensor);
    const auto is_it = [&](const CriticalPoint& p) {
      bool same = p.is_certain && p.low <= value && value <= p.high && p.high - p.low < 1e-6;
      for (std::size_t i = 0; i < k.weights.size(); ++i)
        same &= std::abs(p.weights[i] - static_cast<double>(Real50(k.weights[i] / sum))) < 1e-6;
      return same;
    };
    RC_ASSERT(std::count_if(found.begin(), found.end(), is_it) == 1);
  }
}

TetTensors random_tensors() {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  TetTensors tensors = random.tet_tensors();
  // Some like those of a smooth field: all close to the first.
  if (random.uniform() < 0.5)
    for (std::size_t i = 1; i < 4; ++i) tensors[i] = tensors[0] + 0.125 * tensors[i];
  return tensors;
}

RC_GTEST_PROP(CriticalPoints, OfEdgesAreThoseFoundOtherwise, ()) {
  const TetTensors t = random_tensors();
  compare(critical_points_on_edge({t[0], t[1]}, {}), known_on_edge({t[0], t[1]}));
}

RC_GTEST_PROP(CriticalPoints, OfFacesAreThoseFoundOtherwise, ()) {
  const TetTensors t = random_tensors();
  compare(critical_points_on_face({t[0], t[1], t[2]}, {}), known_on_face({t[0], t[1], t[2]}));
}

RC_GTEST_PROP(CriticalPoints, OfTetrahedraAreThoseFoundOtherwise, ()) {
  const TetTensors t = random_tensors();
  compare(critical_points_in_tet(t), known_in_tet(t));
}

// The mode a small step away, from the tensor at the weights found, polished by nothing: steps are
// larger than their error and smaller than the curvature's radius.
double mode_near(const std::vector<Tensor>& corners, const CriticalPoint& p,
                 const std::vector<Real50>& step) {
  Deviator<Real50> t{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Real50 w = (i < 4 ? Real50(p.weights[i]) : Real50(0)) + step[i];
    t = t + w * deviator(tensor_cast<Real50>(corners[i]));
  }
  return static_cast<double>(Real50((mode(t) - (p.low + p.high) / 2) * Real50("1e20")));
}

// Along an edge the mode rises on both sides of a minimum, and towards other vertices as told.
RC_GTEST_PROP(CriticalPoints, OfEdgesHaveTheTypeThatStepsShow, ()) {
  const TetTensors t = random_tensors();
  const Real50 h("1e-4");
  for (const auto& p : critical_points_on_edge({t[0], t[1]}, std::array{t[2], t[3]})) {
    RC_ASSERT(p.is_certain && p.towards.size() == 2);
    RC_PRE(p.weights[0] > 1e-3 && p.weights[1] > 1e-3);
    const double forth = mode_near(list_of(t), p, {-h, h, 0, 0}),
                 back = mode_near(list_of(t), p, {h, -h, 0, 0});
    RC_PRE(std::abs(forth) > 1e10 && std::abs(back) > 1e10 && (forth > 0) == (back > 0));
    RC_ASSERT((p.index == 0) == (forth > 0));
    const double third = mode_near(list_of(t), p, {0, 0, h * h, 0});
    RC_PRE(std::abs(third) > 1e10);
    RC_ASSERT(p.towards[0] == (third > 0 ? Verdict::positive : Verdict::negative));
  }
}

// Around an extremum of a face the mode is on one side of its value, around a saddle on both.
RC_GTEST_PROP(CriticalPoints, OfFacesHaveTheTypeThatStepsShow, ()) {
  const TetTensors t = random_tensors();
  const Real50 h("1e-4");
  for (const auto& p : critical_points_on_face({t[0], t[1], t[2]}, std::array{t[3]})) {
    RC_PRE(*std::min_element(p.weights.begin(), p.weights.begin() + 3) > 1e-3);
    bool rises = false, falls = false;
    for (int k = 0; k < 64; ++k) {
      const double angle = k * std::acos(-1.0) / 32;
      const Real50 x = h * Real50(std::cos(angle)), y = h * Real50(std::sin(angle));
      const double change = mode_near(list_of(t), p, {-x - y, x, y, 0});
      rises |= change > 1e9;
      falls |= change < -1e9;
    }
    if (rises && falls) RC_ASSERT(p.index == 1);
    if (p.index == 0) RC_ASSERT(rises && !falls);
    if (p.index == 2) RC_ASSERT(falls && !rises);
  }
}

// The saddle of a field is at the origin, its mode -143/343 exactly.
TEST(CriticalPoints, InATetrahedronAreItsSaddle) {
  const auto& witness = field_witness("saddle_origin_rational");
  const auto points = critical_points_in_tet(witness.field.at(witness.cases[0].points));
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].is_certain);
  EXPECT_LE(points[0].low, -143.0 / 343);
  EXPECT_GE(points[0].high, -143.0 / 343);
  EXPECT_LT(points[0].high - points[0].low, 1e-12);
  for (const double w : points[0].weights) EXPECT_NEAR(w, 0.25, 1e-12);
}

// Nearly dependent tensors span the same space, so they have the same saddle.
TEST(CriticalPoints, OfNearlyDependentTensorsAreEnclosedAsWell) {
  const auto& witness = field_witness("saddle_origin_rational");
  for (const int exponent : {-20, -40, -60, -200}) {
    LinearField field = witness.field;
    field.dz = std::ldexp(1.0, exponent) * field.dz;
    const auto points = critical_points_in_tet(field.at(witness.cases[0].points));
    ASSERT_EQ(points.size(), 1u) << exponent;
    EXPECT_LE(points[0].low, -143.0 / 343);
    EXPECT_GE(points[0].high, -143.0 / 343);
    EXPECT_LT(points[0].high - points[0].low, 1e-12) << exponent;
    for (const double w : points[0].weights) EXPECT_NEAR(w, 0.25, 1e-2) << exponent;
  }
}

// All tensors [[1+x, y, 0], [y, 1-x, 0], [0, 0, -2]] share an eigenvector: the mode has its maximum
// 1 on a circle, and its minimum -1 at the centre. Points that are not isolated are not counted,
// and their values enclosed all the same; also if the symmetry is broken by rounding.
TEST(CriticalPoints, OnAPlaneOfSymmetryAreDegenerate) {
  const LinearField ring{{1, 1, -2, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {}};
  for (const double broken : {0.0, 0x1p-46}) {
    using Point = Vector3<double>;
    std::array<Tensor, 3> corners{ring.at(Point{-4, -3, 0}), ring.at(Point{5, -2, 0}),
                                  ring.at(Point{1, 6, 0})};
    corners[1].yz += broken;
    const auto points = critical_points_on_face(corners, {});
    EXPECT_FALSE(points.empty());
    for (const auto& p : points)
      EXPECT_TRUE(p.low > 1 - 1e-6 || p.high < -1 + 1e-6) << p.low << ' ' << p.high;
  }
}

// The mode along this edge has the maximum 4/5 and no other critical point.
TEST(CriticalPoints, OnAnEdgeHaveTheirValue) {
  const Tensor first{0, 0, 0, 1, 2, 1}, second{0, 0, 0, 1, 2, 2};
  const auto points = critical_points_on_edge({first, second}, {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].is_certain);
  EXPECT_EQ(points[0].index, 1);
  EXPECT_LE(points[0].low, 0.8);
  EXPECT_GE(points[0].high, 0.8);
  EXPECT_TRUE(critical_points_on_edge({second, second + (second - first)}, {}).empty());
}

// Where the mode is constant along an edge, nothing is said, and the ends do not claim to know.
TEST(CriticalPoints, OfConstantEdgesAreLeftToTheirEnds) {
  const Tensor t{1, 2, 4, 1, 0, 3};
  EXPECT_TRUE(critical_points_on_edge({t, 3.0 * t}, {}).empty());
  EXPECT_TRUE(critical_points_on_edge({t, -2.0 * t}, {}).empty());
  EXPECT_EQ(critical_vertex(t, std::array{3.0 * t}).towards.at(0), Verdict::unknown);
}

}  // namespace
}  // namespace tensortopo::test
