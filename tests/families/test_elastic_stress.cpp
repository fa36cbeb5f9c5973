// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "support/fields/random_fields.hpp"
#include "tensortopo/families/elastic_stress.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Point = Vector3<Real100>;
using Stress = SymmetricTensor<Real100>;

// The divergence of a stress by central differences: wrong by less than 1e-50 for step 1e-27.
template <class Field>
Point divergence(const Field& field, const Point& p) {
  const Real100 h("1e-27"), half = Real100(1) / (Real100(2) * h), zero(0);
  const std::array<Point, 3> steps{{{h, zero, zero}, {zero, h, zero}, {zero, zero, h}}};
  std::array<Stress, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = half * (field(p + steps[i]) - field(p - steps[i]));
  return {d[0].xx + d[1].xy + d[2].xz, d[0].xy + d[1].yy + d[2].yz, d[0].xz + d[1].yz + d[2].zz};
}

Point random_point(Random& random) {
  return {Real100(random.normal()), Real100(random.normal()), Real100(random.uniform() + 0.25)};
}

TEST(ElasticStress, IsInEquilibriumAwayFromTheForce) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Point force{Real100(random.normal()), Real100(random.normal()), Real100(random.normal())};
    const Real100 poisson(random.uniform() / 2), load(1 + random.uniform());
    const Point p = random_point(random);
    const auto of_kelvin =
        divergence([&](const Point& x) { return kelvin_stress(x, force, poisson); }, p);
    const auto of_boussinesq =
        divergence([&](const Point& x) { return boussinesq_stress(x, load, poisson); }, p);
    EXPECT_LT(dot(of_kelvin, of_kelvin), Real100("1e-90"));
    EXPECT_LT(dot(of_boussinesq, of_boussinesq), Real100("1e-90"));
  }
}

// With a stress that is in equilibrium but violates compatibility a force would be the same: so the
// trace, which is harmonic in any elastic body without body forces, is tested as well.
TEST(ElasticStress, HasHarmonicTrace) {
  Random random(6);
  const Real100 h("1e-20"), poisson(0.3), load(2);
  const Point force{Real100(1), Real100(2), Real100(-1)};
  const std::array<Point, 3> steps{
      {{h, Real100(0), Real100(0)}, {Real100(0), h, Real100(0)}, {Real100(0), Real100(0), h}}};
  for (int i = 0; i < 10; ++i) {
    const Point p = random_point(random);
    const auto laplacian = [&](const auto& field) {
      Real100 sum(0);
      for (const Point& step : steps)
        sum = sum + trace(field(p + step)) + trace(field(p - step)) - Real100(2) * trace(field(p));
      return Real100(sum / (h * h));
    };
    EXPECT_LT(abs(laplacian([&](const Point& x) { return kelvin_stress(x, force, poisson); })),
              Real100("1e-34"));
    EXPECT_LT(abs(laplacian([&](const Point& x) { return boussinesq_stress(x, load, poisson); })),
              Real100("1e-34"));
  }
}

TEST(ElasticStress, OfBoussinesqLeavesTheSurfaceFreeAndCarriesTheLoad) {
  const auto at_surface = boussinesq_stress<double>({0.5, -1.25, 0}, 3, 0.25);
  EXPECT_EQ(at_surface.zz, 0);
  EXPECT_EQ(at_surface.xz, 0);
  EXPECT_EQ(at_surface.yz, 0);
  // On the axis at depth z: T_zz = -3 P / z^2, T_xx = T_yy = P (1 - 2 nu) / (2 z^2).
  const auto on_axis = boussinesq_stress<double>({0, 0, 2}, 8, 0.25);
  EXPECT_DOUBLE_EQ(on_axis.zz, -6);
  EXPECT_DOUBLE_EQ(on_axis.xx, 0.5);
  EXPECT_DOUBLE_EQ(on_axis.yy, 0.5);
  // The tractions on a plane at some depth add up to -2 pi P: midpoints in r = tan(a).
  const double depth = 0.75;
  const int n = 4000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double a = (i + 0.5) / n * pi<double>() / 2, r = std::tan(a);
    const double ring = 2 * pi<double>() * r / (std::cos(a) * std::cos(a)) * pi<double>() / 2 / n;
    sum += ring * boussinesq_stress<double>({r, 0, depth}, 1, 0.25).zz;
  }
  EXPECT_NEAR(sum, -2 * pi<double>(), 1e-5);
}

TEST(ElasticStress, OfKelvinBalancesTheForceOnASphere) {
  const Vector3<double> force{0, 0, 1};
  const double poisson = 0.25, radius = 1.5;
  const int n = 2000;
  double along = 0;
  for (int i = 0; i < n; ++i) {
    const double a = (i + 0.5) / n * pi<double>();
    const Vector3<double> normal{std::sin(a), 0, std::cos(a)};
    const double band = 2 * pi<double>() * std::sin(a) * pi<double>() / n * radius * radius;
    along += band * (kelvin_stress<double>(radius * normal, force, poisson) * normal).z;
  }
  EXPECT_NEAR(along, -8 * pi<double>() * (1 - poisson), 1e-5);
  // On the axis ahead of the force: T_zz = -(1 - 2 nu + 3) / r^2, T_xx = (1 - 2 nu) / r^2.
  const auto ahead = kelvin_stress<double>({0, 0, 2}, force, poisson);
  EXPECT_DOUBLE_EQ(ahead.zz, -0.875);
  EXPECT_DOUBLE_EQ(ahead.xx, 0.125);
}

// Scaled positions, and positions at one angle to the force, have one mode: cones.
TEST(ElasticStress, OfKelvinHasConesForModeSurfaces) {
  Random random(8);
  const Vector3<Real50> force{Real50(0), Real50(0), Real50(2)};
  const Real50 poisson(0.25);
  for (int i = 0; i < 50; ++i) {
    const Vector3<Real50> x{Real50(random.normal()), Real50(random.normal()),
                            Real50(random.normal())};
    const Real50 r = sqrt(x.x * x.x + x.y * x.y), scale(1 + random.uniform());
    const Vector3<Real50> there{r * scale * Real50(3) / Real50(5),
                                r * scale * Real50(4) / Real50(5), x.z * scale};
    const auto mode_at = [&](const Vector3<Real50>& p) {
      return mode(deviator(kelvin_stress(p, force, poisson)));
    };
    EXPECT_LT(abs(mode_at(there) - mode_at(x)), Real50("1e-40"));
  }
}

}  // namespace
}  // namespace tensortopo::test
