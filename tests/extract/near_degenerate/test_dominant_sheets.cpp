// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "extract/cases/extract_case.hpp"
#include "extract/patch/charts/dominant_chart.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using About = DominantChart::About;
CharacteristicTensor<double> characteristic_of(const TetTensors& tensors) {
  TetrahedronField<double> field;
  for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensors[i]);
  return *characteristic_tensor(field);
}

double off(const Vector3<double>& u, const Vector3<double>& v) {
  const auto w = cross(u, v);
  return std::sqrt(dot(w, w)) / std::sqrt(dot(u, u) * dot(v, v));
}

Vector3<double> unit_vector(Random& random) {
  const auto part = [&] { return 2 * random.uniform() - 1; };
  return unit(Vector3<double>{part(), part(), part() + 1e-9});
}

double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

// The eigenvectors of the chart's tensor, from the place by which it was found.
TEST(DominantChart, TensorsHaveTheModeAreInTheFieldAndAreFoundAgain) {
  const std::uint64_t seed = 20261101;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  int found = 0, asked = 0;
  for (int trial = 0; trial < trials(300); ++trial) {
    const auto n = characteristic_of(random.tet_tensors());
    for (const char* mode : {"0", "1/2", "99/100", "999999/1000000", "999999999/1000000000"}) {
      const auto parameter = mode_parameter<double>(ModeValue::parse(mode));
      DominantChart chart(n, parameter, About::cone);
      const DominantChart::Place place{2 * std::numbers::pi * random.uniform(),
                                       2 * std::numbers::pi * random.uniform()};
      ++asked;
      const auto tensor = chart.tensor(place);
      if (!tensor) continue;
      ++found;
      EXPECT_NEAR(inner(*tensor, n.tensor), 0, 1e-12);
      EXPECT_NEAR(tensortopo::mode(deviator(*tensor)), parameter.mu, 1e-12) << mode;
      // The eigenvectors are e and m: T v is along v. From them the same place.
      const auto& [l1, l2, l3] = parameter.eigenvalues;
      const Vector3<double> probe{0.36, 0.48, 0.8};
      const auto identity = [](double x) { return SymmetricTensor<double>{x, x, x, 0, 0, 0}; };
      const auto e = (*tensor + identity(-l2)) * ((*tensor + identity(-l3)) * probe);
      const auto m = (*tensor + identity(-l1)) * ((*tensor + identity(-l3)) * probe);
      if (dot(e, e) < 1e-6 || dot(m, m) < 1e-6 * (l2 - l3) * (l2 - l3)) continue;
      EXPECT_LT(off(*tensor * e, e), 1e-9);
      const auto again = chart.place(unit(e), unit(m));
      const double rounding = 1e-12 / (l2 - l3);
      EXPECT_LT(angle_between(again.around, place.around), 1e-9) << mode;
      EXPECT_LT(angle_between(again.turn, place.turn), 1e-6 + rounding) << mode;
    }
  }
  EXPECT_GT(found, 2 * asked / 3);
}

// Both layouts are one to one, and -e is the same place as e.
TEST(DominantChart, PlacesComeBackFromThePlaneAndFromTheOppositeVector) {
  const std::uint64_t seed = 20261102;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(300); ++trial) {
    const auto n = characteristic_of(random.tet_tensors());
    for (const auto about : {About::cone, About::first_plane, About::second_plane}) {
      DominantChart chart(n, mode_parameter<double>(ModeValue::parse("9999/10000")), about);
      const double cut = 2 * std::numbers::pi * random.uniform();
      chart.cut_at(cut);
      const double least = cut + 0.1 * random.uniform(), most = least + 0.001 + random.uniform();
      const DominantChart::Place place{least + (most - least) * random.uniform(),
                                       2 * std::numbers::pi * random.uniform()};
      const double turn_cut = 2 * std::numbers::pi * random.uniform();
      const double share = 0.1 + 0.8 * random.uniform();
      for (const bool is_cut : {true, false}) {
        chart.lay_out({least, least + (most - least) * share, most}, 0.1 + random.uniform(),
                      is_cut ? std::optional(turn_cut) : std::nullopt);
        const auto again = chart.place_at(chart.point(place));
        EXPECT_NEAR(again.around, place.around, 1e-12);
        EXPECT_LT(angle_between(again.turn, place.turn), 1e-12);
      }
      const auto e = unit_vector(random);
      const auto m = unit(cross(e, unit_vector(random)));
      const auto one = chart.place(e, m), other = chart.place(-e, -m);
      EXPECT_GE(one.around, cut);
      EXPECT_LT(one.around, cut + chart.period());
      EXPECT_NEAR(one.around, other.around, 1e-12);
      EXPECT_LT(angle_between(one.turn, other.turn), 1e-9);
    }
  }
}

/// Independent tensors, those of the face 012 with a common eigenvector, as in a plane of symmetry.
TetTensors beside_a_plane_of_symmetry(Random& random) {
  TetTensors tensors = random.tet_tensors();
  for (std::size_t i = 0; i < 3; ++i) tensors[i].xz = tensors[i].yz = 0;
  return tensors;
}

// There the medium eigenvector is the plane's normal along whole arcs, and thin tubes around the
// degenerate curve in the plane are cut along their length.
TEST(DominantSheets, ShowWhatIsBesideAPlaneOfSymmetry) {
  const std::uint64_t seed = 20261103;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::size_t dominant = 0, subdivision = 0;
  int named = 0, count = 0;
  for (int trial = 0; trial < trials(15); ++trial) {
    const TetTensors tensors = beside_a_plane_of_symmetry(random);
    const TetMesh mesh = reference_tet_mesh(tensors);
    for (const char* mode : {"0", "1/2", "-9/10", "999/1000", "-9999/10000"}) {
      SCOPED_TRACE(std::string(mode) + '\n' + exact_text(tensors));
      ExtractOptions options;
      options.meshing = MeshingMethod::manifold;  // else most are bisected
      const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
      EXPECT_EQ(flaws(extraction, mesh), "");
      ++count;
      named += extraction.unresolved.empty() ? 0 : 1;
      dominant += extraction.statistics.sheets_dominant;
      subdivision += extraction.statistics.sheets_subdivision;
    }
  }
  std::cout << count << " levels: " << dominant << " sheets by dominant eigenvectors, "
            << subdivision << " from leaves, " << named << " tetrahedra named\n";
  EXPECT_EQ(named, 0);
  EXPECT_GT(dominant, subdivision);
}

}  // namespace
}  // namespace tensortopo::test
