// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The library's surfaces in parts, and certificates of parts, against the checker.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "partition/pieces_of_fields.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "proofs-check/parts/parts_in_files.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/partition/certify_pieces.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// The tetrahedra of one owner as a mesh of their own, and their surface.
Exhibit part_of(const PartMesh& own, const PieceSurface& piece, const ModeValue& mode) {
  Exhibit part;
  part.mesh = own.mesh;
  const MergedSurface merged = merge_pieces(std::array{restrict_piece(piece, own.numbers)});
  const CertifiedLevel level = certify(merged, mode);
  part.surface.points = merged.surface.points;
  part.surface.triangles = merged.surface.triangles;
  for (const auto id : merged.cell_ids) part.surface.tet.push_back(static_cast<std::int32_t>(id));
  CertificateSubject subject;
  subject.tensor = "stress", subject.components = "vtk";
  subject.points = part.mesh.points.size(), subject.tetrahedra = part.mesh.tets.size();
  subject.field_sha256 = field_sha256(part.mesh);
  subject.vertices = part.surface.points.size(), subject.cells = part.surface.triangles.size();
  subject.output_sha256 = surface_sha256(part.surface, part.mesh);
  part.certificate = Json::parse(
      certificate_bytes(subject, std::span(&level, 1), merged.cells, CertificateEncoding::json));
  return part;
}

TetMesh random_field(std::uint64_t seed, Random& random) {
  if (random.integer(0, 1) == 0) return field_of_any_kind(random, random.integer(1, 2));
  TetMesh mesh = cube_mesh(random.integer(2, 4));
  fill_with_smooth_tensors(mesh, seed);
  return mesh;
}

/// @param marks  attributes of the last part's tensors
certificate::Report check_parts(const TetMesh& mesh, const std::vector<std::int32_t>& owner,
                                int parts, const ModeValue& mode, Random& random,
                                const std::string& marks = {}) {
  ExtractOptions options;
  options.keep_topology = true;
  const auto pieces = extract_pieces(mesh, owner, parts, mode, options);
  const MergedSurface whole = merge_pieces(pieces);
  PartFiles files("parts", "surface", mode.text());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Exhibit part =
        part_of(part_mesh(mesh, owner, static_cast<int>(p), random), pieces[p], mode);
    std::string field = part.field_text();
    if (p + 1 == pieces.size()) field.insert(field.find("Name=\"stress\""), marks + " ");
    files.add(field, part.surface_text(), part.certificate_text());
  }
  const SurfaceInvariants known = surface_invariants(whole.surface);
  Json claims{{"tetrahedra", mesh.tets.size()},
              {"vertices", whole.surface.points.size()},
              {"triangles", whole.surface.triangles.size()},
              {"components", known.components},
              {"euler_characteristic", known.euler_characteristic},
              {"boundary_loops", known.boundary_loops}};
  const auto report = files.check(claims);
  EXPECT_EQ(report.refuted, 0U) << to_text(report);
  claims["components"] = known.components + 1;
  if (report.status() == "certified") {
    EXPECT_EQ(files.check(claims).refuted, 1U);
  }
  return report;
}

void require_certified(std::uint64_t seed, Compared& compared) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const TetMesh mesh = random_field(seed, random);
  const int parts = random.integer(2, 4);
  const auto owner =
      random.integer(0, 1) == 0 ? slabs(mesh, parts) : random_owners(mesh, parts, random);
  const auto report = check_parts(mesh, owner, parts, random_mode(random), random);
  compared.count(report.status() == "certified" && !report.levels.at(0).components.empty());
}

TEST(CertifiedParts, AreWhatTheWholeIs) {
  Compared compared("certified surfaces in parts", 3);
  for (int i = 0; i < trials(8, 4); ++i)
    require_certified(20261126u + static_cast<unsigned>(i), compared);
}

TEST(CertifiedParts, NamesOfComponentsOfAnyPartAreShown) {
  Random random(20261128);
  TetMesh mesh = cube_mesh(2);
  fill_with_smooth_tensors(mesh, 3);
  const auto names_with = [&](const std::string& marks) {
    const auto report =
        check_parts(mesh, slabs(mesh, 2), 2, ModeValue::parse("1/5"), random, marks);
    EXPECT_EQ(report.status(), "certified") << to_text(report);
    return report.subject.names;
  };
  EXPECT_EQ(names_with("").find("tt"), std::string::npos);
  std::string marks;
  for (const char* name : {"rr", "tt", "zz", "rt", "tz", "rz"})
    marks += " ComponentName" + std::to_string(std::count(marks.begin(), marks.end(), '=')) +
             "=\"" + name + '"';
  EXPECT_NE(names_with(marks).find("tt"), std::string::npos);
}

/// Tetrahedra around an edge between two isotropic vertices, all around or not.
TetMesh ring(std::uint64_t seed, Random& random) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0},      {0, 0, 1},       {1, 0, 0.5},    {0.25, 1, 0.5},
                 {-1, 0.5, 0.5}, {-1, -0.5, 0.5}, {0.25, -1, 0.5}};
  mesh.tensors.resize(7);
  fill_with_normal_tensors(mesh, seed);
  for (std::size_t v = 0; v < 2; ++v) mesh.tensors[v] = {1, 1, 1, 0, 0, 0};
  const std::int32_t count = random.integer(3, 5);
  for (std::int32_t i = 0; i < count; ++i) mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % 5});
  return mesh;
}

// What a part has of a stretch of larger modes joins the sheets that it has at its ends.
TEST(CertifiedParts, FansAroundIsotropicVerticesAreThoseOfTheParts) {
  Compared compared("certified parts of rings", 4);
  for (int i = 0; i < trials(60); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    SCOPED_TRACE("seed " + std::to_string(i));
    Random random(seed);
    const TetMesh mesh = ring(seed, random);
    const ModeValue mode = random_mode(random);
    const auto owner = random_owners(mesh, 2, random);
    compared.count(check_parts(mesh, owner, 2, mode, random).status() == "certified");
  }
}

// Next to mode 1 there is a closed curve around each degenerate point of a face. Their names follow
// from the face alone: the parts number its vertices otherwise.
TEST(CertifiedParts, SeveralClosedCurvesOfASeamAreTold) {
  Compared compared("seams with several closed curves");
  const ModeValue mode = ModeValue::parse("999/1000");
  for (unsigned seed = 1; compared.so_far() < static_cast<std::size_t>(trials(2)); ++seed) {
    ASSERT_LT(seed, 100000U);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    TetMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 1}, {0.25, 0.25, -1}};
    mesh.tensors.resize(5);
    fill_with_normal_tensors(mesh, seed);
    mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    const Json level = exhibit(mesh, {"999/1000"}).certificate["levels"][0];
    const bool has_several =
        std::any_of(level["faces"].begin(), level["faces"].end(), [](const Json& face) {
          return face[0] == 0 && face[1] == 1 && face[2] == 2 && face[4].size() > 1;
        });
    if (!has_several) continue;
    for (int i = 0; i < 2; ++i) {
      const auto report = check_parts(mesh, {0, 1}, 2, mode, random);
      EXPECT_EQ(report.status(), "certified") << to_text(report);
    }
    ++compared;
  }
}

}  // namespace
}  // namespace tensortopo::test
