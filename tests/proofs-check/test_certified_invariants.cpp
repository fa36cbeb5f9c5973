// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces of the magnitude, the deviator's and the anisotropy: what is claimed of them is what the
// checker derives, and nothing else passes.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "proofs-check/forgeries/forgery_trial.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

const Json& first_level(const Exhibit& e) { return e.certificate["levels"][0]; }

/// How often each reason is given.
std::map<std::string, std::size_t> reasons(const Json& level) {
  std::map<std::string, std::size_t> result;
  for (const Json& cell : level["undecided"]) ++result[cell[1].get<std::string>()];
  return result;
}

TEST(CertifiedInvariants, BundledFieldsAreCertified) {
  Court court("invariants");
  const std::vector<std::pair<std::string, std::vector<std::string>>> fields{
      {"s3_",
       {"magnitude 12", "magnitude 6", "deviator-magnitude 9", "deviator-magnitude 4.5",
        "anisotropy 0.8", "anisotropy 2/3"}},
      {"s4_",
       {"magnitude 1/4", "magnitude 1/2", "deviator-magnitude 0.2", "deviator-magnitude 0.4",
        "anisotropy 0.7", "anisotropy 9/10"}}};
  Share share(2);
  for (const auto& [name, levels] : fields) {
    if (!share.has("field")) continue;
    const auto files = bundled_files();
    const auto file = std::find_if(files.begin(), files.end(), [&](const auto& f) {
      return f.string().find(name) != std::string::npos;
    });
    ASSERT_NE(file, files.end());
    const Exhibit e = exhibit(read(*file), levels, 2);
    EXPECT_EQ(court.verdict(e), "certified") << name << '\n' << court.report();
    for (const Json& level : e.certificate["levels"]) {
      EXPECT_GT(level["tets"].size(), 100u) << level["invariant"] << level["value"];
      EXPECT_LT(8 * level["distance"]["coarse"].size(), level["tets"].size());
    }
  }
}

/// Points on the level count whether or not a tetrahedron has them.
TEST(CertifiedInvariants, PointsInNoTetrahedronCount) {
  Court court("unused_points");
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 7);
  mesh.points.push_back({2, 2, 2});
  mesh.tensors.push_back({2, 1, 2, 0, 0, 0});
  const Exhibit shown = exhibit(mesh, {"magnitude 3", "deviator-magnitude 1"});
  EXPECT_EQ(court.verdict(shown), "certified") << court.report();
  EXPECT_EQ(first_level(shown)["on_level"], 1);
}

/// Independent tensors, of any size: sheets of all kinds. Also with zero tensors among them.
RC_GTEST_PROP(CertifiedInvariants, RandomMeshesAreCertifiedOrNamed, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1U << 30);
  const auto invariant =
      *rc::gen::element<std::string>("magnitude", "deviator-magnitude", "anisotropy");
  const int percent = *rc::gen::inRange(5, 100);
  const int size = *rc::gen::element(0, 0, 0, -40, 300);
  const int zeros = *rc::gen::element(0, 0, 1, 4);
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, seed);
  Random random(seed);
  for (int i = 0; i < zeros; ++i)
    mesh.tensors[static_cast<std::size_t>(random.integer(0, 26))] = {};
  mpq_class value(invariant == "anisotropy" ? percent : 4 * percent, 100);
  value.canonicalize();
  if (invariant != "anisotropy") {
    for (auto& t : mesh.tensors) t = std::ldexp(1.0, size) * t;
    if (size > 0) value *= mpz_class(1) << static_cast<unsigned>(size);
    if (size < 0) value /= mpz_class(1) << static_cast<unsigned>(-size);
  }
  const Exhibit e = exhibit(mesh, {invariant + ' ' + value.get_str()});
  Court court("random_invariants");
  const std::string verdict = court.verdict(e);
  const auto& level = first_level(e);
  const bool is_named = zeros > 0 && invariant == "anisotropy" && !level["undecided"].empty();
  RC_LOG() << e.certificate.dump() << court.report();
  RC_ASSERT(verdict == (is_named ? "undecided" : "certified"));
  RC_ASSERT(!is_named || reasons(level)["zero_tensor"] == level["undecided"].size());
  RC_TAG(invariant, verdict);
}

TEST(CertifiedInvariants, ClosedSheetsCurvesAndEdgesCrossedTwice) {
  Court court("special");
  const auto certify_one = [&](const TetTensors& tensors, const char* level) {
    const Exhibit e = exhibit(reference_tet_mesh(tensors), {level}, 2);
    EXPECT_EQ(court.verdict(e), "certified") << level << court.report();
    return first_level(e);
  };
  const Json ellipsoid = certify_one(kAroundZero, "magnitude 1/10");
  EXPECT_EQ(ellipsoid["tets"], Json::parse("[[0, [2]]]"));
  EXPECT_TRUE(ellipsoid["edges"].empty() && ellipsoid["faces"].empty());
  const Json half = certify_one(kZeroInFace, "deviator-magnitude 1/10");
  ASSERT_EQ(half["faces"].size(), 1u);
  EXPECT_EQ(half["faces"][0][4].size(), 1u);
  EXPECT_EQ(half["tets"][0][1][0], 1);
  EXPECT_TRUE(half["edges"].empty());
  const Json quarter = certify_one(kZeroOnEdge, "magnitude 1/10");
  ASSERT_EQ(quarter["edges"].size(), 1u);
  EXPECT_EQ(quarter["edges"][0].size(), 4u);
}

/// A vertex that is exactly on the level counts, and is below it.
TEST(CertifiedInvariants, VerticesOnTheLevel) {
  Court court("on_level");
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 9);
  mesh.tensors[0] = {2, -1, -1, 0, 0, 0};  // |T|^2 = |D|^2 = 6
  mesh.tensors[1] = {0, 0, 0, 0, 1.5, 2};  // |T| = |D| = 5 / sqrt(2)
  mesh.tensors[2] = {3, 0, 0, 0, 0, 0};    // |T| = 3, |D|^2 = 6
  mesh.tensors[3] = {1, 2, 2, 0, 0, 0};    // |T| = 3
  mesh.tensors[4] = {1, 1, 4, 0, 0, 0};    // |D|^2 = 6, |T|^2 = 18
  mesh.tensors[5] = {0, 3, 0, 0, 0, 0};
  for (const auto& [level, count] :
       {std::pair("magnitude 3", 3), std::pair("magnitude 3000001/1000000", 0)}) {
    const Exhibit e = exhibit(mesh, {level});
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    EXPECT_EQ(first_level(e)["on_level"], count) << level;
  }
  Exhibit forged = exhibit(mesh, {"magnitude 3"});
  forged.certificate["levels"][0]["value"] = "2999999999999999999999/1000000000000000000000";
  EXPECT_EQ(court.verdict(forged), "refuted");
  forged.certificate["levels"][0]["value"] = "3000000000000000000001/1000000000000000000000";
  EXPECT_EQ(court.verdict(forged), "refuted");  // though no crossing is elsewhere
}

/// Where the level touches an edge, a face or a point inside, exactly, there is nothing to certify.
TEST(CertifiedInvariants, WhereTheLevelTouchesIsNamed) {
  Court court("touching");
  const std::array<SymmetricTensor<double>, 3> axes{
      {{0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}}};
  const SymmetricTensor<double> near{1, 0, 0, 0, 0, 0};  // the nearest to zero, where it touches
  const auto minus = [](const SymmetricTensor<double>& t) { return -1.0 * t; };
  const TetTensors edge{near + axes[0], near + minus(axes[0]), 2.0 * near + axes[1],
                        2.0 * near + axes[2]};
  const TetTensors face{near + axes[0], near + axes[1], near + minus(axes[0] + axes[1]),
                        2.0 * near + axes[2]};
  const TetTensors cell{near + axes[0], near + axes[1], near + axes[2],
                        near + minus(axes[0] + axes[1] + axes[2])};
  for (const auto& [tensors, reason] :
       {std::pair(edge, "critical_value_on_edge"), std::pair(face, "critical_value_on_face"),
        std::pair(cell, "critical_value_in_cell")}) {
    const Exhibit e = exhibit(reference_tet_mesh(tensors), {"magnitude 1"});
    EXPECT_EQ(court.verdict(e), "undecided") << reason << court.report();
    EXPECT_EQ(reasons(first_level(e))[reason], 1u);
    for (const char* value : {"magnitude 99/100", "magnitude 101/100"}) {
      const Exhibit beside = exhibit(reference_tet_mesh(tensors), {value});
      EXPECT_EQ(court.verdict(beside), "certified") << reason << value << court.report();
      EXPECT_EQ(first_level(beside)["tets"].empty(), std::string(value) == "magnitude 99/100");
    }
  }
}

TEST(CertifiedInvariants, AnotherLevelIsRefuted) {
  Trial trial("other_levels");
  TetMesh mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, 5);
  const std::vector<std::pair<std::string, std::string>> levels{
      {"magnitude", "2"}, {"deviator-magnitude", "2"}, {"anisotropy", "4/5"}};
  for (const auto& [invariant, value] : levels) {
    const Exhibit honest = exhibit(mesh, {invariant + ' ' + value});
    trial.expect("certified", honest, invariant);
    const auto forge = [&](const std::string& verdict, const std::string& what,
                           const std::function<void(Json&)>& change) {
      Exhibit forged = honest;
      change(forged.certificate["levels"][0]);
      trial.expect(verdict, forged, invariant + " as " + what);
    };
    for (const auto& [other, its_value] : levels)
      if (other != invariant)
        forge("refuted", other, [&, name = other, v = its_value](Json& level) {
          level["invariant"] = name, level["value"] = v;
        });
    forge("refuted", "another value", [&](Json& level) {
      level["value"] = invariant == "anisotropy" ? "801/1000" : "2001/1000";
    });
    forge("refuted", "a mode", [](Json& level) {
      level.erase("invariant"), level.erase("value");
      level["mode"] = "1/2";
    });
    for (const char* wrong : {"0", "-1", "4/10", "1e3", "0.5", "1/0", "", " 1", "+1", "0x1p3"})
      forge("malformed", wrong, [&](Json& level) { level["value"] = wrong; });
    forge("malformed", "a number", [](Json& level) { level["value"] = 2; });
    forge("malformed", "no value", [](Json& level) { level.erase("value"); });
    forge("malformed", "no invariant", [](Json& level) { level.erase("invariant"); });
    forge("malformed", "a mode as well", [](Json& level) { level["mode"] = "1/2"; });
    forge("malformed", "trace", [](Json& level) { level["invariant"] = "trace"; });
    if (invariant == "anisotropy")
      for (const char* wrong : {"1", "5/4"})
        forge("malformed", wrong, [&](Json& level) { level["value"] = wrong; });
  }
  Exhibit mode = exhibit(mesh, {"1/2"});
  Json& level = mode.certificate["levels"][0];
  level.erase("mode");
  level["invariant"] = "anisotropy", level["value"] = "1/2";
  trial.expect("refuted", mode, "a mode as an anisotropy");
}

/// Tetrahedra that an anisotropy leaves out hide no claims, and no others are left out.
TEST(CertifiedInvariants, ZeroTensorsAreLeftOutAndNamed) {
  Trial trial("zero_tensors");
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  mesh.tensors[13] = {};
  Exhibit e = exhibit(mesh, {"anisotropy 9/10"});
  trial.expect("undecided", e, "honest");
  Json& level = e.certificate["levels"][0];
  ASSERT_GT(reasons(level)["zero_tensor"], 0u);
  ASSERT_EQ(reasons(level).size(), 1u);
  const Json claimed = level["undecided"];
  level["undecided"].erase(0);
  trial.expect("refuted", e, "one of them claimed to be empty");
  level["undecided"] = claimed;
  level["undecided"][0][1] = "zero";
  trial.expect("malformed", e, "another reason");
}

/// Where they cut the surface in two around an edge, what cannot be named is undecided, not
/// refuted.
TEST(CertifiedInvariants, ManyZeroTensorsAreNamedAndNothingIsRefuted) {
  constexpr std::uint64_t kSeed = 20241203;
  Random random(kSeed);
  Court court("zero_tensors");
  std::size_t cut = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    TetMesh mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, kSeed + static_cast<std::uint64_t>(trial));
    for (int i = 0; i < 6; ++i) mesh.tensors[static_cast<std::size_t>(random.integer(0, 26))] = {};
    const Exhibit e = exhibit(mesh, {"anisotropy 9/10"}, 2);
    EXPECT_EQ(court.verdict(e), "undecided") << "trial " << trial << '\n' << court.report();
    std::set<std::array<double, 3>> places;
    for (const auto& p : e.surface.points) places.insert({p.x, p.y, p.z});
    cut += e.surface.points.size() - places.size();
    const std::size_t zeros = reasons(first_level(e))["zero_tensor"];
    EXPECT_EQ(zeros, first_level(e)["undecided"].size());
  }
  EXPECT_GT(cut, 0u);
}

}  // namespace
}  // namespace tensortopo::test
