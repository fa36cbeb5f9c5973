// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// On one machine: curves of slabs and of a mesh that is read in pieces, alone and beside surfaces,
// are those of the whole, and so are their certificates.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "files_of_pieces.hpp"
#include "pieces_of_curves.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/common_cells.hpp"
#include "tensortopo/partition/extract_in_pieces.hpp"

namespace tensortopo::test {
namespace {

std::string bytes_of(const CertifiedCurves& curves, const TetMesh& mesh) {
  return certificate_bytes({}, std::span(&curves, 1), mesh, CertificateEncoding::json);
}

bool are_same(const std::vector<UnresolvedCurve>& a, const std::vector<UnresolvedCurve>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.tet == q.tet && p.obstacle == q.obstacle;
  });
}

/// What is different in extractions from one mesh; "" if nothing is.
std::string difference_of_extractions(const TetMesh& mesh, Degeneracy kind,
                                      const CurveExtraction& a, const CurveExtraction& b) {
  const CurveMesh &s = a.curves, &t = b.curves;
  if (!are_same_bits(s.points, t.points)) return "points";
  if (s.lines != t.lines || s.tet != t.tet || s.component != t.component) return "lines";
  if (s.carrier != t.carrier || s.carrier_vertices != t.carrier_vertices) return "carriers";
  if (!are_same_bits(s.dominant_eigenvector, t.dominant_eigenvector)) return "eigenvectors";
  if (!are_same_bits(s.mode, t.mode) || !are_same_bits(s.residual, t.residual)) return "modes";
  if (!are_same_bits(s.separation, t.separation)) return "separations";
  if (!are_same(a.unresolved, b.unresolved)) return "unresolved tetrahedra";
  if (!are_same(a.special, b.special)) return "special tetrahedra";
  if (a.statistics.tets_crossed != b.statistics.tets_crossed) return "crossed tetrahedra";
  return bytes_of(certify(mesh, kind, a), mesh) == bytes_of(certify(mesh, kind, b), mesh)
             ? ""
             : "certificates";
}

/// Fields of any kind, and of special positions.
std::vector<TetMesh> some_fields(int count) {
  std::vector<TetMesh> fields;
  const auto kinds = all_mesh_kinds();
  for (int i = 0; i < count; ++i) {
    Random random(20261129u + static_cast<unsigned>(i));
    fields.push_back(i % 2 == 0 ? field_of_any_kind(random, 1 + i % 3, 6)
                                : special_mesh(kinds[as_size(i / 2) % kinds.size()], random));
    fields.back().cell_ids.resize(fields.back().tets.size());
    std::iota(fields.back().cell_ids.begin(), fields.back().cell_ids.end(), std::int64_t{0});
  }
  return fields;
}

TEST(CurvesInPieces, HaveTheBitsAndTheCertificateOfTheWhole) {
  std::size_t lines = 0, special = 0;
  for (const TetMesh& field : some_fields(trials(10)))
    for (const Degeneracy kind : kDegeneracies) {
      const CurveExtraction whole = extract_degenerate_curves(field, kind);
      for (const int pieces : {1, 2, 3, 7}) {
        const CurveExtraction made = extract_in_pieces(field, kind, pieces);
        ASSERT_EQ(difference_of_extractions(field, kind, whole, made), "") << pieces << " pieces";
        lines += whole.curves.lines.size();
        special += whole.special.size() + whole.unresolved.size();
      }
    }
  EXPECT_GE(lines, 100u);
  EXPECT_GE(special, 20u);
}

/// The certificate of a level among others of a streamed mesh.
struct CertificateBytes {
  const CommonCells& common;
  const std::vector<ModeValue>& modes;
  std::size_t level;

  std::string operator()(const Extraction& made) const {
    Extraction extraction = made;
    CertifiedLevel claims = certify(common.cells, modes[level], extraction);
    claims.vertex_ids = common.vertex_ids;
    return certificate_bytes({}, std::span(&claims, 1), common.cells, CertificateEncoding::json);
  }
  std::string operator()(const CurveExtraction& made) const {
    CertifiedCurves claims = certify(common.cells, kDegeneracies[level - modes.size()], made);
    claims.vertex_ids = common.vertex_ids;
    return bytes_of(claims, common.cells);
  }
};

void require_streamed(const TetMesh& mesh, std::uint64_t seed, std::size_t& curves,
                      std::size_t& surfaces) {
  Random random(seed);
  const int pieces = random.integer(1, 7);
  const auto owner = owners_of_kind(random.integer(0, 2), mesh, pieces, random);
  const auto files = files_of(mesh, owner, pieces);
  const TetMesh whole = joined(files);
  const StreamedMesh streamed(source_of(files));
  ExtractOptions options;
  options.keep_topology = true;
  const std::vector<ModeValue> modes{random_mode(random), ModeValue::parse("3/10")};
  std::vector<std::variant<MergedSurface, MergedCurves>> merged;
  for (const ModeValue& mode : modes) merged.emplace_back(extract_streamed(streamed, mode, options));
  for (const Degeneracy kind : kDegeneracies) {
    MergedCurves made = extract_streamed(streamed, kind);
    const CurveExtraction extraction = extract_degenerate_curves(whole, kind);
    ASSERT_EQ(curve_difference(extraction, made), "");
    ASSERT_TRUE(bytes_of(certify(made), made.cells) ==
                bytes_of(certify(whole, kind, extraction), whole));
    curves += extraction.curves.lines.size();
    merged.emplace_back(std::move(made));
  }
  const CommonCells common = in_common_cells(std::move(merged));
  ASSERT_EQ(common.levels.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string made = std::visit(CertificateBytes{common, modes, i}, common.levels[i]);
    if (i >= modes.size()) {
      const Degeneracy kind = kDegeneracies[i - modes.size()];
      const CurveExtraction extraction = extract_degenerate_curves(whole, kind);
      EXPECT_TRUE(made == bytes_of(certify(whole, kind, extraction), whole));
      EXPECT_EQ(curves_sha256(std::get<CurveExtraction>(common.levels[i]).curves, common.cells),
                curves_sha256(extraction.curves, whole));
      continue;
    }
    Extraction extraction = extract_mode_surface<double>(whole, modes[i], options);
    EXPECT_EQ(surface_sha256(std::get<Extraction>(common.levels[i]).surface, common.cells),
              surface_sha256(extraction.surface, whole));
    surfaces += extraction.surface.triangles.size();
    const CertifiedLevel claims = certify(whole, modes[i], extraction);
    EXPECT_TRUE(made == certificate_bytes({}, std::span(&claims, 1), whole,
                                          CertificateEncoding::json));
  }
}

TEST(StreamedCurves, HaveTheBitsAndTheCertificateOfTheWholeBesideSurfaces) {
  std::size_t curves = 0, surfaces = 0;
  const auto fields = some_fields(trials(6, 3));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    SCOPED_TRACE("field " + std::to_string(i));
    require_streamed(fields[i], 20261129u + i, curves, surfaces);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(curves, 50u);
  EXPECT_GE(surfaces, 1000u);
}

}  // namespace
}  // namespace tensortopo::test
