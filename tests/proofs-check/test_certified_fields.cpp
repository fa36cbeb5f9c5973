// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Two programs that share no code agree: what the extractor draws is what the checker derives.
#include <gtest/gtest.h>
#include <unistd.h>

#include "certificate_check/check_certificate.hpp"
#include "certificate_writer.hpp"
#include "extract/bundled_fields.hpp"
#include "forgery.hpp"
#include "support/random_fields.hpp"
#include "support/witness_fields.hpp"

namespace tensortopo::test {
namespace {

std::filesystem::path folder(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("certified_" + name + std::to_string(getpid()));
}

certificate::Report check(const CertifiedSurface& s) {
  return certificate::check_certificate(s.input(), s.surface(), s.write(s.certificate));
}

TEST(CertifiedFields, BundledFieldsAreCertified) {
  for (const auto& file : bundled_files()) {
    const bool is_quick = file.string().find("s2_") != std::string::npos ||
                          file.string().find("s4_") != std::string::npos;
    if (!is_quick) continue;
    const auto s = certified_surface(read(file), {"1/2", "0"}, folder("bundled"));
    const certificate::Report report = check(s);
    EXPECT_EQ(report.status(), "certified") << file << '\n' << to_text(report);
    EXPECT_GT(report.certified, 1000u);
  }
}

TEST(CertifiedFields, RandomMeshesAreNeverRefuted) {
  TetMesh mesh = cube_mesh(2);
  std::size_t certified = 0, undecided = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    fill_with_normal_tensors(mesh, seed);
    const auto s = certified_surface(mesh, {"1/4", "-1/2", "0"}, folder("random"));
    const certificate::Report report = check(s);
    EXPECT_EQ(report.refuted, 0u) << "seed " << seed << '\n' << to_text(report);
    certified += report.certified;
    undecided += report.undecided;
  }
  EXPECT_GT(certified, 1000 * (undecided + 1));
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
  for (const auto& file : bundled_files()) {
    if (file.string().find("s4_") == std::string::npos) continue;
    const Exhibit e = exhibit(read(file), {"99/100", "-9/10"});
    Court court("tubes");
    EXPECT_EQ(court.verdict(e), "certified") << file << '\n' << court.report();
    EXPECT_GT(e.certificate["levels"][0]["tets"].size(), 100u);
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

TEST(CertifiedFields, CborSaysTheSame) {
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 3);
  const auto s = certified_surface(mesh, {"1/2"}, folder("cbor"));
  const auto report = certificate::check_certificate(s.input(), s.surface(),
                                                     s.write(s.certificate, "c.cbor"));
  EXPECT_EQ(report.status(), "certified") << to_text(report);
  EXPECT_EQ(to_json(report), to_json(check(s)));
}

}  // namespace
}  // namespace tensortopo::test
