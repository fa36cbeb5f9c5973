// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Changes of a field that change nothing, or that change it in a known way. The topology claimed of
// every edge, face and tetrahedron is compared, and every certificate is checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "claimed_topology.hpp"
#include "extract/cases/extract_case.hpp"
#include "honest_verdict.hpp"
#include "support/compared.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
using Index = TetMesh::Index;

constexpr std::uint64_t kSeed = 20261123;
constexpr int kLawCases = 6;
constexpr std::array kLawModes{"0", "1/10", "-1/2", "1/2", "-9/10", "99/100"};

const char* law_mode(int number) { return kLawModes[static_cast<std::size_t>(number) % 6]; }

/// A field whose entries have few bits: a tetrahedron, or every third time a cube of six.
TetMesh short_mesh(int number, Random& random) {
  TetMesh mesh = number % 3 == 2 ? cube_mesh(1) : reference_tet_mesh(random.tet_tensors());
  if (number % 3 == 2)
    fill_with_normal_tensors(mesh, static_cast<std::uint64_t>(random.integer(0, 1 << 30)));
  for (Tensor& t : mesh.tensors) t = rounded(t, 16);
  return mesh;
}

ClaimedTopology certified_topology(const TetMesh& mesh, const std::string& mode,
                                   const HonestCourt& court, const std::vector<Index>& to = {}) {
  const Exhibit e = exhibit(mesh, {mode});
  const HonestVerdict verdict = court.judge(e);
  EXPECT_EQ(verdict.status, "certified") << verdict.report;
  return claimed_topology(e.certificate["levels"][0], e.mesh, to);
}

/// `change` alters the tensors, and maybe the mode.
void expect_same_topology(
    const char* law, const std::function<void(TetMesh&, std::string& mode, Random&)>& change) {
  SCOPED_TRACE(announce(kSeed));
  HonestCourt court(law);
  Random random(kSeed);
  Compared compared(law);
  for (int number = 0; number < trials(kLawCases); ++number) {
    const TetMesh mesh = short_mesh(number, random);
    std::string mode = law_mode(number);
    SCOPED_TRACE(std::string(law) + " " + std::to_string(number) + ", mode " + mode);
    const ClaimedTopology before = certified_topology(mesh, mode, court);
    TetMesh other = mesh;
    change(other, mode, random);
    const ClaimedTopology after = certified_topology(other, mode, court);
    EXPECT_EQ(difference(before, after), "");
    compared.count(!before.crossings.empty());
  }
}

/// T with axes permuted and turned around.
Tensor with_axes(const Tensor& t, const std::array<std::size_t, 3>& axis,
                 const std::array<double, 3>& sign) {
  const std::array<std::array<double, 3>, 3> m{
      {{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
  const auto entry = [&](std::size_t i, std::size_t j) {
    return sign[i] * sign[j] * m[axis[i]][axis[j]];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(0, 2)};
}

TEST(MetamorphicLaws, MultiplesOfTheIdentityChangeNothing) {
  expect_same_topology("trace", [](TetMesh& mesh, std::string&, Random& random) {
    for (Tensor& t : mesh.tensors)
      t = t + std::ldexp(random.integer(-1 << 16, 1 << 16), random.integer(0, 18)) *
                  Tensor{1, 1, 1, 0, 0, 0};
  });
}

TEST(MetamorphicLaws, SignedPermutationsOfAxesChangeNothing) {
  expect_same_topology("axes", [](TetMesh& mesh, std::string&, Random& random) {
    std::array<std::size_t, 3> axis{0, 1, 2};
    for (int k = random.integer(0, 5); k > 0; --k) std::ranges::next_permutation(axis);
    std::array<double, 3> sign{};
    for (double& s : sign) s = random.integer(0, 1) ? -1 : 1;
    for (Tensor& t : mesh.tensors) t = with_axes(t, axis, sign);
  });
}

// |q|^4 R T R^T of an integer quaternion is exact.
TEST(MetamorphicLaws, RotationsChangeNothing) {
  expect_same_topology("rotation", [](TetMesh& mesh, std::string&, Random& random) {
    const auto q = random.quaternion();
    for (Tensor& t : mesh.tensors) t = turned(t, q);
  });
}

TEST(MetamorphicLaws, OneFactorForAllTensorsChangesNothing) {
  expect_same_topology("factor", [](TetMesh& mesh, std::string&, Random& random) {
    const double factor = std::ldexp(2 * random.integer(0, 1000) + 1, random.integer(-200, 200));
    for (Tensor& t : mesh.tensors) t = factor * t;
  });
}

// General position: no vertex is on the level, so the level mu + 0 of T is mu - 0 of -T.
TEST(MetamorphicLaws, OppositeTensorsHaveTheOppositeMode) {
  expect_same_topology("opposite", [](TetMesh& mesh, std::string& mode, Random&) {
    for (Tensor& t : mesh.tensors) t = -1.0 * t;
    mode = ModeValue::parse(mode).opposite().text();
  });
}

TEST(MetamorphicLaws, PositionsOfTheMeshChangeNothing) {
  expect_same_topology("positions", [](TetMesh& mesh, std::string&, Random& random) {
    const double a = std::ldexp(1.0, random.integer(-20, 20)), b = random.integer(-3, 3);
    for (auto& p : mesh.points) p = {a * p.x + b * p.y, p.y + 1000 * a, 0.25 * p.z + b * p.x};
  });
}

// Rotations with rounding: they move critical values by some roundings, so fields without a change
// of topology within 1e-9 of the mode are safe.
TEST(MetamorphicLaws, RoundedRotationsChangeNothingFarFromCriticalValues) {
  SCOPED_TRACE(announce(kSeed));
  HonestCourt court("rounded_rotation");
  Random random(kSeed);
  Compared compared("rounded rotations");
  for (int number = 0; number < trials(kLawCases); ++number) {
    const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
    const auto at = [&](const TetMesh& field, const std::string& mode) {
      return claimed_topology(exhibit(field, {mode}).certificate["levels"][0], field);
    };
    const ClaimedTopology here = at(mesh, "1/10");
    const auto q = random.quaternion();
    const double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    TetMesh other = mesh;
    for (Tensor& t : other.tensors) t = (1 / (length * length)) * turned(t, q);
    if (at(mesh, "100000001/1000000000") != here || at(mesh, "99999999/1000000000") != here)
      continue;
    EXPECT_EQ(difference(here, certified_topology(other, "1/10", court)), "");
    compared.count(!here.crossings.empty());
  }
}

TEST(MetamorphicLaws, NumbersOfVerticesAndTetrahedraChangeNothing) {
  SCOPED_TRACE(announce(kSeed));
  HonestCourt court("numbers");
  Random random(kSeed);
  Compared compared("numberings");
  for (int number = 0; number < trials(kLawCases); ++number) {
    const TetMesh mesh = short_mesh(number, random);
    const std::string mode = law_mode(number);
    SCOPED_TRACE(std::to_string(number) + ", mode " + mode);
    std::vector<Index> to(mesh.points.size()), back(mesh.points.size());
    std::iota(to.begin(), to.end(), 0);
    for (std::size_t i = to.size() - 1; i > 0; --i)
      std::swap(to[i], to[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    TetMesh other = mesh;
    for (std::size_t v = 0; v < to.size(); ++v) {
      other.points[static_cast<std::size_t>(to[v])] = mesh.points[v];
      other.tensors[static_cast<std::size_t>(to[v])] = mesh.tensors[v];
      back[static_cast<std::size_t>(to[v])] = static_cast<Index>(v);
    }
    std::ranges::reverse(other.tets);
    for (auto& tet : other.tets) {
      for (Index& v : tet) v = to[static_cast<std::size_t>(v)];
      std::ranges::rotate(tet.begin(), tet.begin() + random.integer(1, 2), tet.begin() + 3);
    }
    EXPECT_EQ(difference(certified_topology(mesh, mode, court),
                         certified_topology(other, mode, court, back)),
              "");
    compared.count();
  }
}

// The surface in many tetrahedra of one linear field is the surface in the one; an edge that was
// divided has the crossings of its parts.
TEST(MetamorphicLaws, OneLinearFieldInManyTetrahedraHasTheTopologyOfTheOne) {
  SCOPED_TRACE(announce(kSeed));
  HonestCourt court("cut");
  Random random(kSeed);
  Compared compared("cut tetrahedra"), edges("divided edges");
  for (int number = 0; number < trials(kLawCases); ++number) {
    const TetMesh one = reference_tet_mesh(short_tensors(random));
    const std::string mode = law_mode(number);
    SCOPED_TRACE("cut " + std::to_string(number) + ", mode " + mode);
    TetMesh many = one;
    const std::vector<Cut> cuts = cut(many, random.integer(1, 5), random);
    const ClaimedTopology whole = certified_topology(one, mode, court);
    ClaimedTopology parts = certified_topology(many, mode, court);
    EXPECT_EQ(whole.components, parts.components);
    compared.count(!whole.components.empty());
    for (std::size_t k = cuts.size(); k-- > 0;) {  // join parts, the last one first
      if (cuts[k].simplex.size() != 2) continue;
      const auto middle = static_cast<Index>(one.points.size() + k);
      const Index a = cuts[k].simplex[0], b = cuts[k].simplex[1];
      const auto crossings = [&](Index v) {
        const auto found = parts.crossings.find({std::min(v, middle), std::max(v, middle)});
        return found == parts.crossings.end() ? 0 : found->second;
      };
      const int sum = crossings(a) + crossings(b);
      if (sum > 0) parts.crossings[{a, b}] = sum;
    }
    for (const auto& [edge, count] : whole.crossings) {
      EXPECT_EQ(parts.crossings[edge], count) << edge[0] << ' ' << edge[1];
      edges.count();
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
