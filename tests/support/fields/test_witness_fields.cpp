// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/oracles/high_precision_mode.hpp"
#include "support/oracles/level_sign.hpp"
#include "random_fields.hpp"
#include "support/compared.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "witness_fields.hpp"

namespace tensortopo::test {
namespace {

Five<Rational> exact(const SymmetricTensor<double>& t) {
  return {Rational(t.xx) - Rational(t.yy), Rational(t.yy) - Rational(t.zz), Rational(t.xy),
          Rational(t.yz), Rational(t.xz)};
}

// Rank of four deviators by exact elimination.
int rank_of(const TetTensors& tensors) {
  std::vector<Five<Rational>> rows;
  for (const auto& t : tensors) rows.push_back(exact(t));
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 5 && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r) {
      const Rational factor = rows[r][column] / rows[rank][column];
      for (std::size_t c = column; c < 5; ++c) rows[r][c] -= factor * rows[rank][c];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

// Whether a tensor that is not zero has exactly this mode.
bool has_mode(const SymmetricTensor<double>& t, const Fraction& mode) {
  const Five<Rational> d = exact(t);
  const Rational m(mode.numerator, mode.denominator);
  const Rational signed_square = m < 0 ? Rational(-(m * m)) : Rational(m * m);
  return level_form<Rational>(square_norm(d), cubic_form(d), signed_square) == 0;
}

bool is_zero(const SymmetricTensor<double>& t) { return square_norm(exact(t)) == 0; }

double mode_of(const SymmetricTensor<double>& t) {
  const Five<long double> d{static_cast<long double>(t.xx) - t.yy,
                            static_cast<long double>(t.yy) - t.zz, t.xy, t.yz, t.xz};
  const long double p = square_norm(d);
  return static_cast<double>(std::sqrt(2.0L) * cubic_form(d) / (p * std::sqrt(p)));
}

TEST(Witnesses, HaveDistinctNamesAndNotes) {
  std::set<std::string> names;
  const auto check = [&](const auto& all) {
    for (const auto& witness : all) {
      EXPECT_TRUE(names.insert(witness.name).second) << witness.name;
      EXPECT_FALSE(witness.note.empty()) << witness.name;
    }
  };
  check(field_witnesses());
  check(planar_witnesses());
  check(stratum_witnesses());
  EXPECT_EQ(field_witness("cylinders").rank, 3);
  EXPECT_THROW(stratum_witness("no such field"), std::out_of_range);
}

TEST(FieldWitness, HasTheRankStated) {
  for (const auto& witness : field_witnesses()) {
    const auto& f = witness.field;
    EXPECT_EQ(rank_of({f.constant, f.dx, f.dy, f.dz}), witness.rank) << witness.name;
  }
}

TEST(FieldWitness, ModeIsStationaryAtTheSaddle) {
  Compared compared("saddles");
  for (const auto& witness : field_witnesses()) {
    if (!witness.saddle) continue;
    const std::array<Vector3<double>, 4> points{
        {{-9, -9, -9}, {9, -9, -9}, {-9, 9, -9}, {-9, -9, 9}}};
    const TetMesh mesh = single_tet_mesh(points, witness.field.at(points));
    const auto precise = precise_mode(mesh, 0, witness.saddle->point, witness.saddle->mode);
    ++compared;
    EXPECT_LT(std::abs(precise.residual), 1e-15) << witness.name;
    EXPECT_LT(precise.gradient, 1e-14) << witness.name;
  }
}

TEST(FieldWitness, ComponentsAreSortedAndTetrahedraAreSolid) {
  for (const auto& witness : field_witnesses()) {
    for (const auto& tet : witness.cases) {
      EXPECT_TRUE(std::is_sorted(tet.components.begin(), tet.components.end())) << witness.name;
      const auto& p = tet.points;
      EXPECT_NE(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])), 0) << witness.name;
    }
  }
}

TEST(PlanarWitness, HasTheModesStatedAtCriticalPoints) {
  for (const auto& witness : planar_witnesses()) {
    for (const auto& point : witness.critical_points) {
      EXPECT_NEAR(mode_of(witness.at(point.x, point.y)), point.mode, 1e-14) << witness.name;
      // Stationary: a small step changes the mode in second order only.
      for (const double step : {-1e-6, 1e-6}) {
        EXPECT_NEAR(mode_of(witness.at(point.x + step, point.y)), point.mode, 1e-10)
            << witness.name;
        EXPECT_NEAR(mode_of(witness.at(point.x, point.y + step)), point.mode, 1e-10)
            << witness.name;
      }
    }
  }
}

TEST(PlanarWitness, RingsWithThreefoldSymmetryHaveThreeMaxima) {
  for (const char* name : {"ring_threefold_weak", "ring_threefold"}) {
    const auto& witness = planar_witness(name);
    for (const auto& point : witness.critical_points) {
      const double c = -0.5, s = std::sqrt(0.75);
      EXPECT_NEAR(mode_of(witness.at(c * point.x, s * point.x)), point.mode, 1e-14) << name;
    }
  }
}

TEST(StratumWitness, HasTheFactsStated) {
  for (const auto& witness : stratum_witnesses()) {
    EXPECT_EQ(rank_of(witness.tensors), witness.rank) << witness.name;
    if (witness.constant_mode) {
      for (const auto& t : witness.tensors) {
        EXPECT_TRUE(has_mode(t, *witness.constant_mode)) << witness.name;
      }
    }
    if (witness.first_vertex_mode) {
      EXPECT_TRUE(has_mode(witness.tensors[0], *witness.first_vertex_mode)) << witness.name;
      EXPECT_FALSE(is_zero(witness.tensors[0])) << witness.name;
    }
    if (witness.zero_point) {
      // All strata live on the corner 0, e_x, e_y, e_z, where coordinates are barycentric.
      const auto& p = *witness.zero_point;
      const auto& t = witness.tensors;
      EXPECT_TRUE(is_zero((1 - p.x - p.y - p.z) * t[0] + p.x * t[1] + p.y * t[2] + p.z * t[3]))
          << witness.name;
    }
  }
}

TEST(StratumWitness, PlaneStrainHasNoOutOfPlaneShear) {
  for (const auto& t : stratum_witness("plane_strain").tensors) {
    EXPECT_EQ(t.yz, 0);
    EXPECT_EQ(t.xz, 0);
  }
}

TEST(StratumWitness, ModesAreOppositeAcrossTheApexOfTheCone) {
  const auto& t = stratum_witness("cone_apex_inside").tensors;
  const auto at = [&](double x, double y, double z) {
    return (1 - x - y - z) * t[0] + x * t[1] + y * t[2] + z * t[3];
  };
  EXPECT_NEAR(mode_of(at(0.25 + 0.125, 0.25, 0.25 - 0.0625)),
              -mode_of(at(0.25 - 0.125, 0.25, 0.25 + 0.0625)), 1e-15);
}

}  // namespace
}  // namespace tensortopo::test
