// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "../field/witness.hpp"
#include "manifold_case.hpp"
#include "tensortopo/scalar/constants.hpp"

namespace tensortopo {
namespace {

using Manifold = MediumEigenvectorManifold<Real50>;

Real50 random_angle() { return Real50(*rc::gen::inRange(-40000, 40001)) / 10000; }

RC_GTEST_PROP(SpheroConalCoordinates, GiveUnitVectorsAndAntipodes, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const Real50 theta = random_angle(), eta = random_angle(), half_turn = pi<Real50>();
  const auto v = m.sphere_point(theta, eta);
  RC_ASSERT(abs(Real50(norm(v) - 1)) < tiny());
  RC_ASSERT(norm(v + m.sphere_point(theta + half_turn, half_turn - eta)) < tiny());
  RC_ASSERT(norm(v - m.sphere_point(-theta, -eta)) < tiny());
}

RC_GTEST_PROP(SpheroConalCoordinates, AreInvertedOnTheWholeSphere, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  const auto at = m.sphero_conal(v);
  RC_ASSERT(at.theta >= 0 && at.theta < 2 * pi<Real50>());
  RC_ASSERT(at.eta >= 0 && at.eta <= pi<Real50>());
  RC_ASSERT(norm(m.sphere_point(at.theta, at.eta) - v) < tiny());
}

RC_GTEST_PROP(SpheroConalCoordinates, HaveOrthogonalCoordinateLines, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const Real50 theta = random_angle(), eta = random_angle(), h("1e-16");
  const auto along_theta = m.sphere_point(theta + h, eta) - m.sphere_point(theta - h, eta);
  const auto along_eta = m.sphere_point(theta, eta + h) - m.sphere_point(theta, eta - h);
  // Central differences are right to h^2 relative to the unit scale: 1e-32.
  RC_ASSERT(abs(dot(along_theta, along_eta)) < Real50("1e-28") * h * h);
}

RC_GTEST_PROP(SpheroConalCoordinates, AreTheEigenvaluesInThePlaneAcross, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  const auto [major, minor] = m.plane_eigenvalues(v);
  const auto at = m.sphero_conal(v);
  const auto& b = c.characteristic->eigenvalues;
  const Real50 st = sin(at.theta), se = sin(at.eta);
  RC_ASSERT(abs(Real50(major - (b[1] + (b[0] - b[1]) * st * st))) < tiny());
  RC_ASSERT(abs(Real50(minor - (b[1] - (b[1] - b[2]) * se * se))) < tiny());
  // Independently: sum and sum of squares of the eigenvalues of P T P.
  const auto& t = c.characteristic->tensor;
  const Real50 alpha = dot(v, t * v), beta = dot(t * v, t * v);
  RC_ASSERT(abs(Real50(major + minor + alpha)) < tiny());
  RC_ASSERT(abs(Real50(major * major + minor * minor - (1 - 2 * beta + alpha * alpha))) < tiny());
  for (std::size_t i = 0; i < 3; ++i) {
    const Real50 x = dot(c.characteristic->eigenvectors[i], v);
    RC_ASSERT(abs(Real50(x * x * (3 * b[i] * b[i] - Real50(1) / 2) -
                         (b[i] - major) * (b[i] - minor))) < tiny());
  }
}

RC_GTEST_PROP(SpheroConalCoordinates, MakeTheBoundaryAStraightSegment, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const Real50 theta = random_angle(), eta = random_angle();
  const auto v = m.sphere_point(theta, eta);
  const auto [major, minor] = m.plane_eigenvalues(v);
  const Real50 g = (1 + c.mode.s) * major - (1 - c.mode.s) * minor;
  RC_ASSERT(g >= 0);
  RC_ASSERT(abs(Real50(m.F(theta, eta) - ((1 - c.mode.s) * major - (1 + c.mode.s) * minor))) <
            tiny());
  RC_ASSERT(abs(Real50(m.boundary_function(v) - m.F(theta, eta) * g / 4)) < tiny());
  RC_ASSERT(m.q() > m.c());
}

TEST(SpheroConalCoordinates, OfTheSingularitiesAreTheCorners) {
  for (const auto& f : witness::full_rank) {
    const Manifold m(*characteristic_tensor(witness::unit_tetrahedron<Real50>(f)),
                     mode_parameter<Real50>(ModeValue::parse("0.3")));
    const Real50 zero(0), half_turn = pi<Real50>();
    const auto& [s1, s2] = m.singularities();
    EXPECT_LT(norm(m.sphere_point(zero, zero) - s1), tiny()) << f.name;
    EXPECT_LT(norm(m.sphere_point(half_turn, zero) - s2), tiny()) << f.name;
    EXPECT_LT(norm(m.sphere_point(half_turn, half_turn) + s1), tiny()) << f.name;
    EXPECT_LT(norm(m.sphere_point(zero, half_turn) + s2), tiny()) << f.name;
    for (const auto& s : {s1, s2}) {
      const auto [major, minor] = m.plane_eigenvalues(s);
      EXPECT_LT(abs(Real50(major - minor)), tiny()) << f.name;
      const auto at = m.sphero_conal(s);
      EXPECT_LT(norm(m.sphere_point(at.theta, at.eta) - s), tiny()) << f.name;
    }
  }
}

TEST(SpheroConalCoordinates, ResolveTheNeighbourhoodOfASingularityInDoubles) {
  const MediumEigenvectorManifold<double> m(
      *characteristic_tensor(witness::unit_tetrahedron<double>(witness::saddle_origin)),
      mode_parameter<double>(ModeValue::parse("0.3")));
  for (const double theta : {1e-9, 1e-6, 1e-3})
    for (const double eta : {1e-9, 1e-6, 1e-3}) {
      const auto at = m.sphero_conal(m.sphere_point(theta, eta));
      // The vector holds its distance to the singularity, of order theta^2 + eta^2, to 1e-16.
      const double unit = 4e-16 / (theta * theta + eta * eta);
      EXPECT_NEAR(at.theta * at.theta, theta * theta, 4e-16 + unit * theta * theta);
      EXPECT_NEAR(at.eta * at.eta, eta * eta, 4e-16 + unit * eta * eta);
    }
}

TEST(SpheroConalCoordinates, ContainTheAxesAndPlanesOfSymmetry) {
  const MediumEigenvectorManifold<double> m(
      *characteristic_tensor(witness::unit_tetrahedron<double>(witness::generic_1)),
      mode_parameter<double>(ModeValue::parse("0.3")));
  const auto& e = m.characteristic().eigenvectors;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const auto v = unit_vector<double>(x, y, z);
        const auto w = v.x * e[0] + v.y * e[1] + v.z * e[2];
        const auto at = m.sphero_conal(w);
        EXPECT_LT(norm(m.sphere_point(at.theta, at.eta) - w), 4e-8) << x << y << z;
      }
}

}  // namespace
}  // namespace tensortopo
