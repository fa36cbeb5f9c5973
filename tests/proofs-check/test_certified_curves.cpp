// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Two programs that share no code agree on degenerate curves: what the extractor draws is what the
// checker derives.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "curves/curve_topology.hpp"
#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/curves/points/degenerate_points_on_face.hpp"
#include "proofs-check/forgeries/curve_exhibit.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/strata_fields.hpp"
#include "support/generators.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/families/helix_field.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/families/special_tets.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

constexpr bool kIsLong = TENSORTOPO_EDITS > 10000;
constexpr int kTrials = kIsLong ? 30 : 2;

const std::vector<Degeneracy> kBoth{Degeneracy::linear, Degeneracy::planar};

std::string verdict(Court& court, const CurveExhibit& e) {
  return court.verdict(e.field_text(), e.curve_text(), e.certificate.dump());
}

std::size_t count(const CurveExhibit& e, const char* list) {
  std::size_t all = 0;
  for (const Json& level : e.certificate["levels"]) all += level[list].size();
  return all;
}

TEST(CertifiedCurves, OfBundledFieldsAreCertified) {
  Court court("bundled_curves");
  const std::vector<const char*> names =
      kIsLong ? std::vector{"s1", "s2", "s3", "s4"} : std::vector{"s1", "s4"};
  for (const char* name : names) {
    const auto file = bundled_file(name);
    const CurveExhibit e = curve_exhibit(read(file), kBoth);
    EXPECT_EQ(verdict(court, e), "certified") << file << '\n' << court.report();
    EXPECT_EQ(count(e, "undecided"), 0u);
    EXPECT_GT(count(e, "tets"), 300u);
  }
}

TEST(CertifiedCurves, OfIndependentTensorsAreCertified) {
  const std::uint64_t seed = 20260401;
  Court court("normal_curves");
  std::size_t pieces = 0, faces = 0;
  for (std::uint64_t trial = 0; trial < 3 * kTrials; ++trial) {
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, seed + trial);
    const CurveExhibit e = curve_exhibit(mesh, kBoth);
    EXPECT_EQ(verdict(court, e), "certified") << "seed " << seed + trial << '\n' << court.report();
    EXPECT_EQ(count(e, "undecided"), 0u);
    for (const Json& level : e.certificate["levels"]) {
      for (const Json& tet : level["tets"]) pieces += tet.size() > 2;
      for (const Json& face : level["faces"]) faces += face.size() > 4;
    }
  }
  EXPECT_GT(pieces, 10u);  // tetrahedra with several
  EXPECT_GT(faces, 10u);   // faces with several points
}

TEST(CertifiedCurves, OfSmoothFieldsAndAHelixAreCertified) {
  Court court("smooth_curves");
  TetMesh mesh = cube_mesh(5);
  fill_with_smooth_tensors(mesh, 20260402);
  EXPECT_EQ(verdict(court, curve_exhibit(mesh, kBoth)), "certified") << court.report();
  TetMesh helix = kuhn_box({7, 7, 9}, {-1.61, -1.57, -2}, {1.59, 1.63, 2});
  const HelixField field;
  for (std::size_t v = 0; v < helix.points.size(); ++v) helix.tensors[v] = field(helix.points[v]);
  const CurveExhibit e = curve_exhibit(helix, {Degeneracy::linear});
  EXPECT_EQ(verdict(court, e), "certified") << court.report();
  EXPECT_GT(count(e, "tets"), 20u);
}

TEST(CertifiedCurves, WithTensorsOfDifferentMagnitudesAreCertified) {
  Court court("scaled_curves");
  Random random(7);
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20260403);
  for (auto& t : mesh.tensors) t = std::ldexp(1.0, random.integer(-30, 30)) * t;
  const CurveExhibit e = curve_exhibit(mesh, kBoth);
  EXPECT_EQ(verdict(court, e), "certified") << court.report();
  EXPECT_GT(count(e, "tets"), 10u);
}

// Dominant eigenvectors of small integers, which are where the checker cuts its arcs first.
TEST(CertifiedCurves, WhereTheCheckerCutsAreCertified) {
  Court court("simple_directions");
  const TetMesh mesh = reference_tet_mesh({{{1984, -4272, 2288, -848, -368, 432},
                                            {-3264, 1728, 1536, -2048, -1808, 720},
                                            {1536, -3264, 1728, 1504, -1264, -1024},
                                            {0, 1344, -1344, 1120, 2576, 1792}}});
  const CurveExhibit e = curve_exhibit(mesh, kBoth);
  EXPECT_EQ(verdict(court, e), "certified") << court.report();
  EXPECT_EQ(count(e, "faces"), 4u);
}

TEST(CertifiedCurves, WithoutAnyAreCertified) {
  Court court("no_curves");
  const SymmetricTensor<double> t{1, 0, -1, 0, 0, 0};
  TetMesh mesh = cube_mesh(1);
  std::fill(mesh.tensors.begin(), mesh.tensors.end(), t);
  const CurveExhibit e = curve_exhibit(mesh, kBoth);
  EXPECT_EQ(verdict(court, e), "certified") << court.report();
  EXPECT_TRUE(e.curves.points.empty());
}

TEST(CertifiedCurves, ChangeTheirModeAndNothingElseWhenAllSignsChange) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20260404);
  Json one = curve_exhibit(mesh, kBoth).certificate["levels"];
  for (auto& t : mesh.tensors) t = -1.0 * t;
  Json two = curve_exhibit(mesh, {kBoth[1], kBoth[0]}).certificate["levels"];
  for (Json& level : one) level["mode"] = level["mode"] == "1" ? "-1" : "1";
  EXPECT_EQ(one, two);
}

/// Special positions are left out by name, the rest is certified, and nothing is refuted.
TEST(CertifiedCurves, InSpecialPositionAreNamedAndNeverRefuted) {
  Court court("special_curves");
  std::map<std::string, std::size_t> reasons;
  std::size_t tried = 0, open = 0, certified = 0;
  const auto expect_named = [&](const TetMesh& mesh, const std::string& what) {
    const CurveExhibit e = curve_exhibit(mesh, kBoth);
    const std::string found = verdict(court, e);
    ++tried;
    EXPECT_TRUE(found == "undecided" || found == "certified") << what << '\n' << court.report();
    EXPECT_EQ(found == "certified", count(e, "undecided") == 0) << what << '\n'
                                                                << e.field_text() << '\n'
                                                                << court.report();
    certified += found == "certified";
    open += court.report().find("no proof closes") != std::string::npos;
    for (const Json& level : e.certificate["levels"])
      for (const Json& cell : level["undecided"]) ++reasons[cell[1]];
  };
  RandomSource source(20260405);
  for (const Speciality speciality : all_specialities())
    for (int trial = 0; trial < kTrials; ++trial)
      expect_named(special_tet(speciality, source), std::string(name_of(speciality)));
  Random random(20260406);
  for (const Stratum stratum : all_strata())
    for (int trial = 0; trial < kTrials; ++trial)
      expect_named(reference_tet_mesh(stratum_tensors(stratum, random)), name_of(stratum));
  // Small integers: planes of symmetry, points on edges, isotropic vertices.
  for (int trial = 0; trial < 3 * kTrials; ++trial) {
    TetMesh mesh = cube_mesh(2);
    for (auto& t : mesh.tensors)
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = random.integer(-1, 1);
    expect_named(mesh, "integers " + std::to_string(trial));
  }
  // Plane strain.
  TetMesh mesh = cube_mesh(2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    mesh.tensors[v] = {p.x - 0.75, 0.75 - p.x, 4, p.y - 0.625, 0, 0};
  }
  expect_named(mesh, "plane strain");
  for (const auto& [reason, times] : reasons) std::cout << reason << ' ' << times << '\n';
  EXPECT_GT(reasons.size(), 4u);
  EXPECT_GT(certified, 0u);
  EXPECT_EQ(open, 0u) << tried;
}

/// The checker's count for a face beside the extractor's.
void compare_counts(const std::array<SymmetricTensor<double>, 3>& tensors, std::size_t& compared) {
  certificate::Input input;
  input.points.resize(3);
  TetMesh mesh;
  mesh.points.resize(3);
  mesh.tensors.assign(tensors.begin(), tensors.end());
  for (const auto& t : tensors) input.tensors.push_back({t.xx, t.yy, t.zz, t.xy, t.yz, t.xz});
  const certificate::Field field(input, certificate::Multiples{},
                                 [](std::size_t count, const auto& f, const char*) {
                                   for (std::size_t v = 0; v < count; ++v) f(v);
                                 });
  const ScaledField<double> scaled(mesh);
  std::array<certificate::Corner, 3> corners;
  std::array<ScaledTensor, 3> given;
  for (std::uint32_t v = 0; v < 3; ++v) {
    if (field.is_zero(v)) return;
    corners[v] = field.corner(v, false);
    given[v] = {tensors[v], scaled.exponents[v]};
  }
  const FacePoints expected = degenerate_points_on_face(given);
  for (const bool linear : {false, true}) {
    const auto found = certificate::points_in_face(
        corners, linear ? certificate::Kind::linear : certificate::Kind::planar);
    if (linear ? expected.concerns_linear : expected.concerns_planar) continue;
    RC_ASSERT(found.decided);
    const auto same = std::count_if(expected.points.begin(), expected.points.end(),
                                    [&](const FacePoint& p) { return p.linear == linear; });
    RC_ASSERT(found.points.size() == static_cast<std::size_t>(same));
    ++compared;
  }
}

RC_GTEST_PROP(CertifiedCurves, HaveAsManyPointsOnAFaceAsTheExtractorCounts, ()) {
  const TetSample sample = *rc::gen::oneOf(normal_tet(), small_integer_tet(2));
  const auto& t = sample.tensors;
  std::size_t compared = 0;
  compare_counts({t[0], t[1], t[2]}, compared);
  RC_CLASSIFY(compared == 0, "all special");
}

}  // namespace
}  // namespace tensortopo::test
