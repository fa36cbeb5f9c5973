// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The curves in some of a piece's tetrahedra are those of a mesh which has no others.
#include <gtest/gtest.h>

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "pieces_of_curves.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/restrict_piece.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

/// Half of the tetrahedra of an owner as a mesh of their own, with vertices in the order given.
struct HalfMesh {
  TetMesh mesh;
  PartNumbers numbers;
};

HalfMesh half_of(const TetMesh& mesh, const std::vector<std::int32_t>& owner, std::int32_t which,
                 Random& random) {
  HalfMesh half;
  std::map<Index, Index> number;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (owner[t] != which || random.integer(0, 1) == 0) continue;
    auto corners = mesh.tets[t];
    for (Index& v : corners) {
      const auto [known, is_new] =
          number.try_emplace(v, static_cast<Index>(half.mesh.points.size()));
      if (is_new) {
        half.numbers.vertices.push_back({v, known->second});
        half.mesh.points.push_back(mesh.points[as_size(v)]);
        half.mesh.tensors.push_back(mesh.tensors[as_size(v)]);
      }
      v = known->second;
    }
    const auto id = static_cast<std::int64_t>(half.mesh.tets.size());
    half.numbers.tets.push_back({static_cast<std::int64_t>(t), id});
    half.mesh.tets.push_back(corners);
    half.mesh.cell_ids.push_back(id);
  }
  return half;
}

std::string certificate_of_curves(const CertifiedCurves& curves, const TetMesh& mesh) {
  return certificate_bytes({}, std::span(&curves, 1), mesh, CertificateEncoding::json);
}

TEST(RestrictedCurves, AreThoseOfThePartAndSoIsTheCertificate) {
  std::size_t lines = 0;
  for (int field = 0; field < trials(16, 8); ++field) {
    SCOPED_TRACE("field " + std::to_string(field));
    Random random(20261202u + static_cast<unsigned>(field));
    TetMesh mesh = cube_mesh(random.integer(2, 3));
    fill_with_normal_tensors(mesh, 20261202u + static_cast<unsigned>(field));
    const auto owner = random_owners(mesh, 3, random);
    for (const Degeneracy kind : kDegeneracies)
      for (const PieceCurves& piece : curve_pieces(mesh, owner, 3, kind)) {
        if (piece.owned_ids.empty()) continue;
        const HalfMesh half =
            half_of(mesh, owner, owner[as_size(piece.owned_ids[0][0])], random);
        const MergedCurves made =
            merge_curve_pieces(std::array{restrict_piece(piece, half.numbers)});
        CurveExtraction whole = extract_degenerate_curves(half.mesh, kind);
        // They depend on lines around, of which the part has not all.
        whole.curves.separation = made.curves.separation;
        whole.curves.residual = made.curves.residual;
        ASSERT_EQ(curve_difference(whole, made), "");
        ASSERT_TRUE(certificate_of_curves(certify(made), made.cells) ==
                    certificate_of_curves(certify(half.mesh, kind, whole), half.mesh));
        lines += whole.curves.lines.size();
      }
  }
  EXPECT_GE(lines, 500u);
}

TEST(RestrictedCurves, AreOfTetrahedraThatThePieceOwns) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  const auto owner = slabs(mesh, 2);
  const auto pieces = curve_pieces(mesh, owner, 2, Degeneracy::linear);
  Random random(1);
  HalfMesh half = half_of(mesh, owner, 0, random);
  EXPECT_NO_THROW(restrict_piece(pieces[0], half.numbers));
  EXPECT_THROW(restrict_piece(pieces[1], half.numbers), std::invalid_argument);
  half.numbers.tets[1][1] = half.numbers.tets[0][1];
  EXPECT_THROW(restrict_piece(pieces[0], half.numbers), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
