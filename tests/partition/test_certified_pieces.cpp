// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The certificate of a surface put together from pieces is that of the whole, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/extract_in_pieces.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

ExtractOptions with_topology() {
  ExtractOptions options;
  options.keep_topology = true;
  return options;
}

std::string bytes_of(const CertifiedLevel& level, const TetMesh& mesh) {
  return certificate_bytes({}, std::span(&level, 1), mesh, CertificateEncoding::json);
}

std::string certificate_of(const TetMesh& mesh, const ModeValue& mode, Extraction extraction) {
  return bytes_of(certify(mesh, mode, extraction), mesh);
}

std::string whole_certificate(const TetMesh& mesh, const ModeValue& mode) {
  const PreparedField<double> field(mesh);
  Extraction extraction = extract_mode_surface(field, mode, with_topology());
  return bytes_of(certify(field, mode, extraction), mesh);
}

/// With `cell_ids` that are not the positions of the tetrahedra.
TetMesh numbered(TetMesh mesh) {
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(3 * t + 1));
  return mesh;
}

void require_certificate_of_whole(std::uint64_t seed, Compared& compared) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  TetMesh mesh = numbered(field_of_any_kind(random, random.integer(1, 2)));
  mesh.points.push_back({9, 9, 9});  // in no tetrahedron
  mesh.tensors.push_back(mesh.tensors[0]);
  const int pieces = random.integer(1, 5);
  const auto owner =
      owners_of_kind(2 * random.integer(0, 1), mesh, pieces, random);  // slabs, or at random
  const ModeValue mode = random_mode(random);
  const std::string whole = whole_certificate(mesh, mode);
  compared.count(whole.size() > 1000);

  auto surfaces = extract_pieces(mesh, owner, pieces, mode, with_topology());
  std::reverse(surfaces.begin(), surfaces.end());
  CertifiedLevel level = certify(merge_pieces(surfaces), mode);
  // Pieces that were cut here name cells by their positions.
  for (auto& id : level.cell_ids) id = mesh.cell_ids[as_size(static_cast<Index>(id))];
  EXPECT_TRUE(bytes_of(level, {}) == whole);
  const Extraction again = extract_in_pieces(mesh, mode, pieces, with_topology());
  EXPECT_TRUE(certificate_of(mesh, mode, again) == whole);
}

TEST(CertifiedPieces, HaveTheCertificateOfTheWholeMesh) {
  Compared compared("certificates with claims", 3);
  for (int i = 0; i < trials(16, 8); ++i)
    require_certificate_of_whole(20261124u + static_cast<unsigned>(i), compared);
}

TEST(CertifiedPieces, NeedTheProofsOfAllPieces) {
  Random random(20261124);
  const TetMesh mesh = field_of_any_kind(random, 2);
  const auto owner = slabs(mesh, 2);
  const ModeValue mode = ModeValue::parse("1/2");
  auto surfaces = extract_pieces(mesh, owner, 2, mode, with_topology());
  EXPECT_NO_THROW(certify(merge_pieces(surfaces), mode));
  surfaces[1].topology.reset();
  EXPECT_THROW(certify(merge_pieces(surfaces), mode), std::invalid_argument);
}

TEST(CertifiedPieces, HaveToProveTheSameOfWhatTheyShare) {
  TetMesh mesh = cube_mesh(3);
  fill_with_smooth_tensors(mesh, 20261124);
  const auto owner = slabs(mesh, 3);
  const ModeValue mode = ModeValue::parse("0");
  const auto surfaces = extract_pieces(mesh, owner, 3, mode, with_topology());
  EXPECT_NO_THROW(merge_pieces(surfaces));
  int refused = 0;
  for (std::size_t e = 0; e < surfaces[1].topology->edges.size(); ++e) {
    auto other = surfaces;
    auto& crossing = other[1].topology->edges[e].crossings[0];
    crossing.rising = !crossing.rising;
    try {
      merge_pieces(other);
    } catch (const PiecesDiffer& error) {
      EXPECT_NE(std::string(error.what()).find("the proofs differ"), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace tensortopo::test
