// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/families/helix_field.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

TEST(UnitCircle, AgreesWithTheMathematicalLibrary) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const double turns = 8 * random.uniform() - 4;
    const auto [c, s] = unit_circle(turns);
    const long double angle = 2 * std::numbers::pi_v<long double> * turns;
    EXPECT_NEAR(c, static_cast<double>(std::cos(angle)), 2e-15) << turns;
    EXPECT_NEAR(s, static_cast<double>(std::sin(angle)), 2e-15) << turns;
  }
}

TEST(HelixField, HasTheModeOfItsFormula) {
  const HelixField field{1.25, 0.4, 0.5};
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vector3<double> p{random.normal(), random.normal(), random.normal()};
    const auto c = field.helix(p.z);
    const double q2 = 0.25 * ((p.x - c.x) * (p.x - c.x) + (p.y - c.y) * (p.y - c.y));
    const double mode_there = 6 * std::sqrt(6.0) * (1 - q2) / std::pow(6 + 2 * q2, 1.5);
    EXPECT_NEAR(mode(deviator(field(p))), mode_there, 1e-13);
    EXPECT_NEAR(mode(deviator(field(c))), 1, 1e-15);
  }
}

// The largest distance, at equal height, of the extracted curve's vertices from the helix.
double distance_to_helix(std::size_t tetrahedra) {
  const HelixField field{1, 0.25, 0.5};
  const int n = cells_for({1, 1, 1}, tetrahedra)[0];
  TetMesh mesh = kuhn_box({n, n, n}, {-1.6, -1.7, -1.25}, {1.7, 1.65, 1.25});
  sample_field(mesh, field);
  const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear);
  EXPECT_TRUE(extraction.unresolved.empty());
  const auto known = curve_invariants(extraction.curves);
  EXPECT_EQ(known.components, 1u);
  EXPECT_EQ(known.closed_components, 0u);
  double largest = 0, low = 0, high = 0;
  for (const auto& p : extraction.curves.points) {
    const auto c = field.helix(p.z);
    largest = std::max(largest, std::hypot(p.x - c.x, p.y - c.y));
    low = std::min(low, p.z), high = std::max(high, p.z);
  }
  EXPECT_DOUBLE_EQ(low, -1.25);  // it runs from the floor to the ceiling
  EXPECT_DOUBLE_EQ(high, 1.25);
  return largest;
}

TEST(HelixField, SampledHasItsDegenerateCurveWhereTheFormulaSays) {
  const double coarse = distance_to_helix(10368), fine = distance_to_helix(82944);
  EXPECT_LT(coarse, 0.15);
  EXPECT_LT(fine, coarse / 3);  // of second order in the size of the cells
}

}  // namespace
}  // namespace tensortopo::test
