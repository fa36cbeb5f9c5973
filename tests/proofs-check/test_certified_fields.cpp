// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Two programs that share no code agree: what the extractor draws is what the checker derives.
#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "certificate_check/check_certificate.hpp"
#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "proofs-check/forgeries/certificate_writer.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/strata_fields.hpp"
#include "support/fields/witness_fields.hpp"

namespace tensortopo::test {
namespace {

std::filesystem::path folder(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) /
         ("certified_" + name + std::to_string(getpid()));
}

certificate::Report check(const CertifiedSurface& s) {
  return certificate::check_certificate(s.input(), s.surface(), s.write(s.certificate));
}

TEST(CertifiedFields, BundledFieldsAreCertified) {
  for (const char* name : full_or_short<std::vector<const char*>>({"s2", "s4"}, {"s4"})) {
    const auto file = bundled_file(name);
    const auto s = certified_surface(read(file), {"1/2", "0"}, folder("bundled"));
    const certificate::Report report = check(s);
    EXPECT_EQ(report.status(), "certified") << file << '\n' << to_text(report);
    EXPECT_GT(report.certified, 1000u);
  }
}

/// Triangles beside such a level reach far past mode 0, and past the level of the opposite mode.
TEST(CertifiedFields, DistancesNearModeZeroAreCertified) {
  const Exhibit e = exhibit(read(bundled_file("s1")), {"9/200"});
  Court court("near_zero");
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
  EXPECT_EQ(e.certificate["levels"][0]["distance"]["reach"].size(), e.surface.points.size());
}

TEST(CertifiedFields, RandomMeshesAreNeverRefuted) {
  TetMesh mesh = cube_mesh(2);
  std::size_t certified = 0, undecided = 0;
  for (int seed = 1; seed <= trials(6, 3); ++seed) {
    fill_with_normal_tensors(mesh, static_cast<std::uint64_t>(seed));
    const auto s = certified_surface(mesh, {"1/4", "-1/2", "0"}, folder("random"));
    const certificate::Report report = check(s);
    EXPECT_EQ(report.refuted, 0u) << "seed " << seed << '\n' << to_text(report);
    certified += report.certified;
    undecided += report.undecided;
  }
  EXPECT_GT(certified, 1000 * (undecided + 1));
}

/// Next to a vertex with a small tensor the field is a sum of tiny multiples of large ones: how a
/// position is rounded off a face decides what the field is there. Eigenvectors are those of the
/// point of the face.
TEST(CertifiedFields, EigenvectorsBesideTensorsOfOtherMagnitudesAreNotRefuted) {
  TetMesh mesh;
  mesh.points = {{0x1.5e515bb972dd7p-4, 0x1.c4d6a129cddefp-1, 0x1.0fa73931fa83fp-3},
                 {0x1.ec7ed0da71300p-4, 0x1.eda99efd5d9c0p-1, 0x1.b87a0c33b717fp-1},
                 {0x1.44f18e583d244p-3, 0x1.f37c517805bd0p+0, -0x1.03759d3762873p-6},
                 {0x1.706853becbb9ap-9, 0x1.f8f43a54eb3e2p+0, 0x1.168f53c928f2cp+0},
                 {0x1.244baa891f704p+0, 0x1.d59e981365ad7p+0, 0x1.0037931fdf345p+0}};
  mesh.tets = {{0, 2, 3, 4}, {0, 1, 4, 3}};
  mesh.tensors = {{-0x1.704770fc5ef82p-15, 0x1.57e548a18625cp-13, -0x1.c3232f951ef80p-16,
                   0x1.16db6dd0d483bp-13, -0x1.032cab466e878p-14, 0x1.5467e3a326668p-14},
                  {-0x1.a4c34c2b66058p+56, 0x1.de09d0b1475b0p+57, -0x1.83abc28f4745bp+56,
                   0x1.60f556dc69ec3p+56, -0x1.5c671c8c44eadp+56, 0x1.57fdb84b45200p+54},
                  {-0x1.7c4b3faac5a7ep+18, 0x1.12f60bee670b0p+20, -0x1.339a0fde12c87p+20,
                   0x1.fd91d8f29b8ccp+18, -0x1.9938823906fdcp+20, -0x1.45ce6d79bb8c7p+18},
                  {-0x1.dd7cb383fdfc1p+12, 0x1.4d49f0a9168fbp+14, -0x1.29e05e547dd48p+13,
                   0x1.1d602346e9d45p+13, -0x1.197f7ce30086ap+14, -0x1.277b6fc2d2d33p+12},
                  {0x1.5ad19feb60b3ep-5, 0x1.57087b7c7a40ep+0, -0x1.36c17d56a7b79p+0,
                   0x1.33054b9166764p+0, -0x1.d8c3f9c928df4p-1, -0x1.ba8512d032aecp-2}};
  const Exhibit e = exhibit_with_arrays(mesh, {"9/10"});
  Court court("magnitudes");
  EXPECT_NE(court.verdict(e), "refuted") << court.report();
  EXPECT_GT(e.surface.points.size(), 5u);
}

TEST(CertifiedFields, WitnessesAreCertifiedOrNamed) {
  std::size_t certified = 0;
  for (const FieldWitness& witness : field_witnesses()) {
    for (const TetCase& c : witness.cases) {
      const TetMesh mesh = single_tet_mesh(c.points, witness.field.at(c.points));
      const std::string mode =
          std::to_string(c.mode.numerator) + "/" + std::to_string(c.mode.denominator);
      const auto s = certified_surface(mesh, {mode}, folder("witness"));
      const certificate::Report report = check(s);
      EXPECT_EQ(report.refuted, 0u) << witness.name << ' ' << mode << '\n' << to_text(report);
      if (report.status() == "certified") ++certified;
    }
  }
  EXPECT_GE(certified, 10u);
}

/// Near the ends tetrahedra hold thin tubes: some cells have several curves on their boundaries.
TEST(CertifiedFields, ThinTubesAndDistancesAreCertified) {
  const Exhibit e = exhibit(read(bundled_file("s4")), {"99/100", "-9/10"});
  Court court("tubes");
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
  EXPECT_GT(e.certificate["levels"][0]["tets"].size(), 100u);
}

/// A tube that turns back to the face that it came from, and is nearly pinched there: 13,287 parts.
TEST(CertifiedFields, ATubeThatTurnsBackIsCertified) {
  const TetTensors tensors{{{-0x1.aa407f84ab49dp-2, -0x1.b7a6d1b9f1563p-2, -0x1.99919745ce6b2p-2,
                             0x1.73cb2ccdeadep-3, 0x1.d0aab760ec902p-4, 0x1.fcfe6ab3fa2bcp-7},
                            {-0x1.2433c8cb5c296p-2, -0x1.484baa78db1f1p-2, -0x1.6848a8f87e5fdp-2,
                             0x1.bbeb827f295a1p-4, 0x1.d2f2105cde017p-7, 0x1.143d7405f6fa7p-4},
                            {-0x1.b36c6ebfadc76p-2, -0x1.c82b1bfaf22bbp-2, -0x1.a7858b1b8ab68p-2,
                             0x1.957e61b115897p-3, 0x1.2d1198dc7d038p-4, -0x1.11088492452c7p-4},
                            {-0x1.5afc5ed46bab5p-4, -0x1.65c08db5372e1p-3, -0x1.d7d7af324167cp-3,
                             -0x1.03bc8d56099f6p-1, -0x1.3fa3be4e8208cp-4, 0x1.704337fd55f4ap-4}}};
  const Exhibit e = exhibit(reference_tet_mesh(tensors), {"-4999/5000"});
  Court court("tube");
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
  ASSERT_EQ(e.certificate["levels"][0]["tets"].size(), 1u);
  const auto& tube = e.certificate["levels"][0]["tets"][0][1];
  EXPECT_EQ(tube[0], 0);
  ASSERT_EQ(tube.size(), 3u);
  EXPECT_EQ(tube[1][1], tube[2][1]);  // both loops are closed curves of one face
}

/// The stress of a bent beam: one tensor times the height above the neutral layer, and a small
/// rest, which alone decides in that layer.
TEST(CertifiedFields, ABentBeamIsCertified) {
  Court court("beam");
  for (const double rest : {1e-4, 1e-9, 1e-12}) {
    TetMesh mesh = cube_mesh(1);
    Random random(20241205);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto& p = mesh.points[v];
      const SymmetricTensor<double> tension{p.z - 0.43 + 0.1 * p.x, 0, 0, 0, 0, 0};
      mesh.tensors[v] = tension + rest * random.tensor();
    }
    const Exhibit e = exhibit(mesh, {"1/2", "-9/10", "0"});
    EXPECT_EQ(court.verdict(e), "certified") << rest << '\n' << court.report();
    EXPECT_EQ(e.certificate["levels"][0]["tets"].size(), mesh.tets.size());
  }
}

/// Next to a zero inside, on a face or on an edge both programs go straight to it, each in its way.
TEST(CertifiedFields, FieldsThatNearlyVanishAreCertified) {
  Court court("small");
  constexpr std::uint64_t first = 20241301;
  for (const auto stratum :
       {Stratum::cone_apex_inside, Stratum::zero_on_face, Stratum::zero_on_edge})
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(trials(4)); ++seed) {
      const auto tensors = nearly_in_stratum(stratum, 0x1p-36, seed);
      const Exhibit e = exhibit(reference_tet_mesh(tensors), {"1/2", "-9/10", "99/100"});
      EXPECT_EQ(court.verdict(e), "certified")
          << name_of(stratum) << ' ' << exact_text(tensors) << '\n'
          << court.report();
    }
}

/// The field of diag(1 - s, 2 s, -1 - s), s = x + y / 100 - 0.3: the levels are planes, which the
/// triangles hit but for rounding. Far from the origin coordinates are rounded by more.
TEST(CertifiedFields, PlanesAreProvedToBeNear) {
  for (const double far : {0.0, 1e6}) {
    TetMesh mesh = cube_mesh(1);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double s = mesh.points[v].x - 0.3 + 0.01 * mesh.points[v].y;
      mesh.tensors[v] = {1 - s, 2 * s, -1 - s, 0, 0, 0};
      mesh.points[v].x += far;
    }
    const Exhibit e = exhibit(mesh, {"1/2"});
    Court court("planes");
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    const std::string bound = e.certificate["levels"][0]["distance"]["bound"];
    EXPECT_LT(std::strtod(bound.c_str(), nullptr), 1e-6);
    EXPECT_EQ(e.certificate["levels"][0]["distance"]["coarse"].size(), 0u) << bound;
  }
}

/// Isotropic vertices one by one, in rows, in blocks.
TEST(CertifiedFields, ConesAreCertified) {
  constexpr std::uint64_t kSeed = 20241130;
  Random random(kSeed);
  Court court("cones");
  std::size_t cones = 0, joins = 0, proved = 0;
  for (int trial = 0; trial < trials(15, 7); ++trial) {
    TetMesh mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, kSeed + static_cast<std::uint64_t>(trial));
    const int percent = std::array{5, 15, 30, 50, 80}[static_cast<std::size_t>(trial) % 5];
    for (auto& t : mesh.tensors)
      if (random.integer(0, 99) < percent) t = {7, 7, 7, 0, 0, 0};
    const char* const mode =
        std::array{"1/4", "-1/2", "0", "9/10"}[static_cast<std::size_t>(trial) % 4];
    const Exhibit e = exhibit(mesh, {mode});
    EXPECT_EQ(court.verdict(e), "certified") << "trial " << trial << '\n' << court.report();
    const auto& level = e.certificate["levels"][0];
    EXPECT_TRUE(level["undecided"].empty());
    std::set<nlohmann::json> coarse(level["distance"]["coarse"].begin(),
                                    level["distance"]["coarse"].end());
    for (const auto& cone : level["cones"]) {
      ++cones;
      if (cone[1].size() == 4) ++joins;
      if (!coarse.contains(cone[0])) ++proved;
    }
  }
  EXPECT_GT(cones, 50u);
  EXPECT_GT(joins, 20u);
  EXPECT_GT(2 * proved, cones);
}

/// One tetrahedron with one to four isotropic vertices, of any magnitude and order.
TEST(CertifiedFields, StrataWithZeroVerticesAreCertified) {
  constexpr std::uint64_t kSeed = 20241131;
  Random random(kSeed);
  Court court("strata");
  for (const Stratum stratum : {Stratum::zero_vertex, Stratum::two_zero_vertices,
                                Stratum::three_zero_vertices, Stratum::rank_zero}) {
    for (int trial = 0; trial < trials(12); ++trial) {
      TetTensors tensors = stratum_tensors(stratum, random);
      const double scale = std::ldexp(1.0, random.integer(-300, 300));
      for (auto& t : tensors) t = scale * t;
      std::rotate(tensors.begin(), tensors.begin() + trial % 4, tensors.end());
      const std::string mode = std::array{"1/3", "-1/2", "0"}[static_cast<std::size_t>(trial) % 3];
      const Exhibit e = exhibit(reference_tet_mesh(tensors), {mode});
      const bool is_special = !e.certificate["levels"][0]["undecided"].empty();
      EXPECT_EQ(court.verdict(e), is_special ? "undecided" : "certified")
          << name_of(stratum) << " trial " << trial << '\n'
          << court.report();
    }
  }
}

/// How many vertices further fans around crossings have.
std::size_t count_copies(const nlohmann::json& level) {
  std::size_t count = 0;
  for (const auto& edge : level["edges"])
    for (std::size_t k = 2; k < edge.size(); ++k) count += edge[k].size() - 3;
  return count;
}

/// Each part's fan of triangles has a vertex of its own in the common crossing.
TEST(CertifiedFields, PartsThatTouchInAnEdgeAreApart) {
  const TetMesh mesh = two_tets_at_an_edge();
  Court court("touching");
  for (const char* level : {"1/4", "0", "magnitude 29/20", "deviator-magnitude 29/20"}) {
    const Exhibit e = exhibit(mesh, {level});
    EXPECT_EQ(court.verdict(e), "certified") << level << '\n' << court.report();
    const auto& claims = e.certificate["levels"][0];
    EXPECT_GT(count_copies(claims), 0u) << level;
    EXPECT_GE(claims["components"].size(), 2u) << level;
  }
}

/// Levels through vertices, along edges, at saddles: much is left out, and more stays open.
TEST(CertifiedFields, LevelsInSpecialPositionAreNotRefuted) {
  TetMesh mesh = cube_mesh(2);
  Court court("special");
  std::size_t open = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Random random(seed);
    const auto entry = [&] { return random.integer(-2, 2); };
    for (auto& t : mesh.tensors)
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = entry();
    for (const char* mode : {"0", "1/2"}) {
      const Exhibit e = exhibit(mesh, {mode});
      EXPECT_NE(court.verdict(e), "refuted") << seed << ' ' << mode << '\n' << court.report();
      if (court.report().starts_with("undecided")) ++open;
    }
  }
  EXPECT_GT(open, 0u);
}

/// An edge that the level touches: it stays open, and so do the cones around it.
TEST(CertifiedFields, ConesOverWhatStaysOpenAreNotRefuted) {
  constexpr std::array<std::array<int, 6>, 27> entries{
      {{1, 0, 0, -1, 1, 0},   {0, 0, 1, -1, 0, -1},  {1, -1, 1, -1, -1, -1}, {0, 0, 1, 0, 1, 0},
       {0, -1, 1, 1, 0, 0},   {-1, 0, -1, -1, 0, 1}, {1, 0, -1, 0, 0, 1},    {1, -1, 0, 1, 0, 0},
       {-1, -1, 1, -1, 1, 1}, {0, 0, -1, 1, -1, -1}, {1, 1, 0, -1, -1, 1},   {1, 0, 0, 0, 1, 0},
       {-1, -1, 1, -1, 0, 0}, {-1, -1, 1, 1, -1, 1}, {0, -1, -1, 0, 0, -1},  {-1, 0, 0, -1, 0, 1},
       {-1, 1, 0, 0, 1, 1},   {0, 0, 0, 0, 0, 0},    {-1, -1, 0, 1, -1, 1},  {0, 0, -1, -1, 0, 0},
       {1, 1, 1, 0, -1, 0},   {1, 1, 1, -1, 0, 0},   {1, 1, 1, 0, 0, 0},     {1, 1, 0, 0, 1, -1},
       {1, -1, 0, 1, 0, 0},   {1, 0, 0, 0, 1, 1},    {1, 0, 0, 0, 1, 0}}};
  TetMesh mesh = cube_mesh(2);
  for (std::size_t v = 0; v < entries.size(); ++v) {
    const auto& [xx, yy, zz, xy, yz, xz] = entries[v];
    mesh.tensors[v] = {1.0 * xx, 1.0 * yy, 1.0 * zz, 1.0 * xy, 1.0 * yz, 1.0 * xz};
  }
  Court court("open_cones");
  EXPECT_EQ(court.verdict(exhibit(mesh, {"0"})), "undecided") << court.report();
}

/// Two of the six tetrahedra around the cube's diagonal hold a zero deviator: two parts are left.
TEST(CertifiedFields, LeftOutTetrahedraMayPartWhatIsAroundAnEdge) {
  TetMesh mesh = cube_mesh(1);
  Court court("parted_diagonal");
  std::size_t parted = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    fill_with_normal_tensors(mesh, seed);
    auto& t = mesh.tensors;
    for (auto& tensor : t) tensor = rounded(tensor, 8);
    t[7] = -1.0 * (t[0] + t[1] + t[3]);
    t[4] = -1.0 * (t[0] + t[7] + t[6]);
    const Exhibit e = exhibit(mesh, {"0"});
    const std::string verdict = court.verdict(e);
    EXPECT_NE(verdict, "refuted") << seed << '\n' << court.report();
    EXPECT_NE(verdict, "malformed") << seed << '\n' << court.report();
    parted += count_copies(e.certificate["levels"][0]);
  }
  EXPECT_GT(parted, 0u);
}

TEST(CertifiedFields, ProgressIsToldStageByStage) {
  TetMesh mesh = cube_mesh(3);
  fill_with_smooth_tensors(mesh, 3);
  const auto s = certified_surface(mesh, {"1/2"}, folder("progress"));
  std::vector<std::string> stages;
  double last = 0;
  const auto report = certificate::check_certificate(s.input(), s.surface(), s.write(s.certificate),
                                                     [&](std::string_view what, double part) {
                                                       if (stages.empty() || stages.back() != what)
                                                         stages.emplace_back(what), last = 0;
                                                       EXPECT_GE(part, last) << what;
                                                       EXPECT_LT(part, 1) << what;
                                                       last = part;
                                                     });
  // This certificate claims no distances.
  const std::vector<std::string> expected{"sides of vertices", "where the level is", "edges",
                                          "faces", "tetrahedra"};
  EXPECT_EQ(stages, expected);
  EXPECT_EQ(to_json(report), to_json(check(s)));
}

TEST(CertifiedFields, CborSaysTheSame) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 3);
  const auto s = certified_surface(mesh, {"1/2"}, folder("cbor"));
  const auto report =
      certificate::check_certificate(s.input(), s.surface(), s.write(s.certificate, "c.cbor"));
  EXPECT_EQ(report.status(), "certified") << to_text(report);
  EXPECT_EQ(to_json(report), to_json(check(s)));
}

}  // namespace
}  // namespace tensortopo::test
