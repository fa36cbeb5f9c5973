// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "support/oracles/brute_force.hpp"
#include "support/compared.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/families/elastic_stress.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/families/single_tets.hpp"
#include "tensortopo/families/special_tets.hpp"
#include "tensortopo/field/field_strata.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

FamilyMember member_of(FieldKind kind, int member, int members, std::uint64_t seed = 1) {
  FamilyRequest request;
  request.seed = seed, request.member = member, request.members = members;
  return family_member(kind, request);
}

std::array<SymmetricTensor<double>, 4> corners(const TetMesh& mesh) {
  std::array<SymmetricTensor<double>, 4> t;
  for (std::size_t i = 0; i < 4; ++i)
    t[i] = mesh.tensors[static_cast<std::size_t>(mesh.tets[0][i])];
  return t;
}

TEST(Families, AreValidMeshesAndRepeatable) {
  for (const FieldKind kind : all_field_kinds()) {
    EXPECT_EQ(field_kind(name_of(kind)), kind);
    for (int member = 0; member < 4; ++member) {
      const auto made = member_of(kind, member, 4), again = member_of(kind, member, 4);
      EXPECT_TRUE(validate(made.mesh).empty()) << name_of(kind);
      EXPECT_FALSE(made.modes.empty());
      EXPECT_EQ(made.mesh.tensors, again.mesh.tensors);
      if (kind == FieldKind::block || kind == FieldKind::nongeneric) continue;
      EXPECT_NE(made.mesh.tensors, member_of(kind, member, 4, 2).mesh.tensors) << name_of(kind);
    }
  }
  EXPECT_THROW(member_of(FieldKind::linear, 2, 2), std::invalid_argument);
}

TEST(Families, OfBifurcationChangeTopologyAcrossTheirMode) {
  const int members = 8;
  for (int i = 0; i < members; ++i) {
    const auto made = member_of(FieldKind::bifurcation, i, members);
    const auto tensors = corners(made.mesh);
    EXPECT_EQ(field_strata(tensors).rank, 4);
    const auto extraction = extract_mode_surface<double>(made.mesh, made.modes.front());
    ASSERT_TRUE(extraction.unresolved.empty());
    const auto known = surface_invariants(extraction.surface);
    // The level is mu(1/4): below the saddle's mode for larger s, above it for smaller s.
    if (i < members / 2) {
      EXPECT_EQ(known.components, 2u) << i;
      EXPECT_EQ(known.euler_characteristic, 2) << i;
    } else {
      EXPECT_EQ(known.components, 1u) << i;
      EXPECT_EQ(known.euler_characteristic, 0) << i;
    }
    const auto truth = brute_force_topology(corners_of(tensors), made.modes.front().approx());
    if (!truth) continue;
    EXPECT_EQ(truth->components.size(), known.components) << i;
  }
}

TEST(Families, OfPlanarExtremaHaveThoseExtremaAndClosedCurves) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (int i = 0; i < 3; ++i) {
      const auto made = member_of(FieldKind::planar_extrema, i, 3, seed);
      // The face is that of the first three points.
      TriangleField<double> face;
      for (std::size_t v = 0; v < 3; ++v) face.vertex[v] = deviator(made.mesh.tensors[v]);
      const auto degenerate = degenerate_points(face);
      const auto others = nondegenerate_critical_points(face);
      ASSERT_TRUE(degenerate.isolated);
      const auto expected = kPlanarCounts[static_cast<std::size_t>(i)];
      EXPECT_EQ(degenerate.points.size() + others.size(),
                static_cast<std::size_t>(expected.extrema + expected.saddles));
      std::size_t extrema = degenerate.points.size();
      for (const auto& point : others) extrema += point.type == CriticalType::extremum;
      EXPECT_EQ(extrema, static_cast<std::size_t>(expected.extrema));
      ExtractOptions options;
      options.keep_topology = true;
      std::size_t loops = 0;
      for (const auto& mode : made.modes) {
        const auto extraction = extract_mode_surface<double>(made.mesh, mode, options);
        for (const auto& f : extraction.topology.faces)
          if (f.vertices == std::array<TetMesh::Index, 3>{0, 1, 2}) loops += f.loops.size();
      }
      EXPECT_GT(loops, 0u) << made.note << ", seed " << seed;
    }
}

TEST(Families, ThatAreNotGenericAreSo) {
  Compared compared("members named by their reason", 5);
  const std::set<std::string> reasons{"zero_deviator_inside", "level_constant_in_cell",
                                      "level_constant_on_face", "level_constant_on_edge"};
  const auto& all = all_specialities();
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto made =
          member_of(FieldKind::nongeneric, static_cast<int>(i), static_cast<int>(all.size()), seed);
      const std::string name(name_of(all[i]));
      const auto strata = field_strata(corners(made.mesh));
      if (!special_level(all[i]) || all[i] == Speciality::degenerate_characteristic) {
        EXPECT_FALSE(strata.is_general()) << name << ", seed " << seed;
      }
      const auto extraction = extract_mode_surface<double>(made.mesh, made.modes.front());
      if (all[i] == Speciality::vertex_on_level) {
        EXPECT_GT(extraction.statistics.vertices_on_level, 0u);
      }
      if (all[i] == Speciality::antiplane_shear || all[i] == Speciality::rank_two) {
        EXPECT_EQ(strata.rank, 2) << name << ", seed " << seed;
      }
      if (all[i] == Speciality::rank_one) {
        EXPECT_EQ(strata.rank, 1) << "seed " << seed;
      }
      if (all[i] == Speciality::rank_zero) {
        EXPECT_EQ(strata.rank, 0) << "seed " << seed;
      }
      if (name.rfind("rank_", 0) == 0) {
        EXPECT_TRUE(extraction.unresolved.empty()) << name << ", seed " << seed;
      }
      if (all[i] == Speciality::antiplane_shear) {
        ASSERT_EQ(extraction.unresolved.size(), 1u) << "seed " << seed;
        EXPECT_EQ(extraction.unresolved[0].reason, UnresolvedReason::level_constant_in_cell);
      }
      if (reasons.contains(name)) {
        ++compared;
        ASSERT_EQ(extraction.unresolved.size(), 1u) << name << ", seed " << seed;
        EXPECT_EQ(name_of(extraction.unresolved[0].reason), name) << "seed " << seed;
      }
    }
}

TEST(KuhnMesh, HoldsAboutTheTetrahedraAskedFor) {
  EXPECT_EQ(cells_for({1, 1, 1}, 48), (std::array<int, 3>{2, 2, 2}));
  EXPECT_EQ(cells_for({1, 1, 1}, 49), (std::array<int, 3>{3, 3, 3}));
  EXPECT_EQ(kuhn_box({2, 3, 4}, {}, {1, 1, 1}).tets.size(), 6u * 24);
  FamilyRequest request;
  request.tetrahedra = 286416;
  request.seed = 4;  // the slab
  const auto slab = family_member(FieldKind::block, request).mesh;
  EXPECT_EQ(slab.tets.size(), 6u * (54 * 36 * 24 + 18 * 36 * 6));
  EXPECT_TRUE(validate(slab).empty());
}

TEST(SideBySide, KeepsTheParts) {
  const std::vector<TetMesh> parts{member_of(FieldKind::complex, 0, 2).mesh,
                                   member_of(FieldKind::complex, 1, 2).mesh};
  const auto all = side_by_side(parts);
  EXPECT_TRUE(validate(all).empty());
  ASSERT_EQ(all.tets.size(), parts[0].tets.size() + parts[1].tets.size());
  const auto mode = ModeValue::parse("1/2");
  const auto whole = surface_invariants(extract_mode_surface<double>(all, mode).surface);
  long euler = 0;
  std::size_t components = 0;
  for (const auto& part : parts) {
    const auto known = surface_invariants(extract_mode_surface<double>(part, mode).surface);
    euler += known.euler_characteristic, components += known.components;
  }
  EXPECT_EQ(whole.euler_characteristic, euler);
  EXPECT_EQ(whole.components, components);
}

}  // namespace
}  // namespace tensortopo::test
