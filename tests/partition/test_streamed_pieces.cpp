// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A mesh that is read piece by piece has the surface and the certificate of the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

#include "files_of_pieces.hpp"
#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/mesh/torn_faces.hpp"
#include "tensortopo/mesh/unmatched_faces.hpp"
#include "tensortopo/mesh/validate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo::test {
namespace {

void require_bits_of_whole(std::uint64_t seed, Compared& compared) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
  const int pieces = random.integer(1, 7);
  const auto owner =
      owners_of_kind(2 * random.integer(0, 1), mesh, pieces, random);  // slabs, or at random
  const auto files = files_of(mesh, owner, pieces);
  const TetMesh whole = joined(files);
  const ModeValue mode = random_mode(random);
  ExtractOptions options;
  options.keep_topology = true;
  const StreamedMesh streamed(source_of(files));
  EXPECT_EQ(streamed.points(), whole.points.size());
  EXPECT_EQ(streamed.tets(), whole.tets.size());
  EXPECT_EQ(streamed.field_sha256(), field_sha256(whole));
  const MergedSurface merged = extract_streamed(streamed, mode, options);

  Extraction extraction = extract_mode_surface<double>(whole, mode, options);
  const SurfaceMesh &a = extraction.surface, &b = merged.surface;
  compared.count(!a.triangles.empty());
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_TRUE(a.points.empty() || std::memcmp(a.points.data(), b.points.data(),
                                              a.points.size() * sizeof(a.points[0])) == 0);
  EXPECT_TRUE(a.triangles == b.triangles && a.tet == b.tet && a.component == b.component);
  const CertifiedLevel of_whole = certify(whole, mode, extraction);
  const CertifiedLevel of_pieces = certify(merged, mode);
  const auto json = CertificateEncoding::json;
  EXPECT_TRUE(certificate_bytes({}, std::span(&of_whole, 1), whole, json) ==
              certificate_bytes({}, std::span(&of_pieces, 1), {}, json));
}

TEST(StreamedPieces, HaveTheSurfaceAndTheCertificateOfTheWhole) {
  Compared compared("surfaces with triangles", 3);
  for (int i = 0; i < trials(8, 4); ++i)
    require_bits_of_whole(20261124u + static_cast<unsigned>(i), compared);
}

std::string refusal(const std::vector<TetMesh>& files) {
  try {
    const StreamedMesh mesh(source_of(files));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(StreamedPieces, HaveToBeOfOneField) {
  Random random(20261124);
  const TetMesh mesh = field_of_any_kind(random, 2);
  const auto files = files_of(mesh, slabs(mesh, 2), 2);
  EXPECT_EQ(refusal(files), "");
  auto other = files;
  for (auto& t : other[1].tensors) t.xy += 1;
  EXPECT_NE(refusal(other).find("different tensors at the same point"), std::string::npos);
  other = files;
  other[0].points.push_back(other[1].points[0]);
  other[0].points.push_back(other[1].points[0]);
  for (int i = 0; i < 2; ++i) other[0].tensors.push_back(other[1].tensors[0]);
  EXPECT_NE(refusal(other).find("two points of a piece coincide"), std::string::npos);
  other = files;
  for (auto& tet : other[1].tets) std::swap(tet[0], tet[1]);
  EXPECT_NE(refusal(other).find("negative volume"), std::string::npos) << refusal(other);
  EXPECT_NE(refusal(std::vector<TetMesh>{}), "");
  ExtractOptions options;
  options.density.assign(mesh.tets.size(), 1.f);
  EXPECT_THROW(extract_streamed(StreamedMesh(source_of(files)), ModeValue::parse("0"), options),
               std::invalid_argument);
}

/// Adds a tetrahedron of the whole mesh, and those of its points that are missing.
void add_tet(TetMesh& file, const TetMesh& mesh, std::size_t t) {
  auto corners = mesh.tets[t];
  for (TetMesh::Index& v : corners) {
    const auto& point = mesh.points[as_size(v)];
    const auto same = std::find(file.points.begin(), file.points.end(), point);
    if (same == file.points.end()) file.tensors.push_back(mesh.tensors[as_size(v)]);
    v = static_cast<TetMesh::Index>(same - file.points.begin());
    if (same == file.points.end()) file.points.push_back(point);
  }
  file.cell_ids.push_back(static_cast<std::int64_t>(file.tets.size()));
  file.tets.push_back(corners);
}

/// As those of ghost layers that are not marked: one tetrahedron, or a layer, or the whole piece.
TEST(StreamedPieces, DoNotOverlap) {
  Compared compared("refused meshes in pieces", 20);
  for (int i = 0; i < trials(80, 50); ++i) {
    SCOPED_TRACE(i);
    Random random(20261129u + static_cast<unsigned>(i));
    const TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
    const int pieces = random.integer(2, 4);
    const auto owner =
        owners_of_kind(2 * random.integer(0, 1), mesh, pieces, random);  // slabs, or at random
    auto files = files_of(mesh, owner, pieces);
    if (refusal(files) != "") continue;  // points of the mesh are in one place
    const int rarity = random.integer(0, 2) == 0 ? 1 : random.integer(2, 200);
    const int into = random.integer(0, pieces - 1);
    int added = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (owner[t] == (into + 1) % pieces && random.integer(1, rarity) == 1)
        add_tet(files[as_size(into)], mesh, t), ++added;
    if (added == 0) continue;
    compared.count(true);
    EXPECT_FALSE(validate(joined(files)).empty());
    EXPECT_NE(refusal(files).find("overlap"), std::string::npos) << refusal(files);
  }
}

/// Puts a point in the middle of an edge.
void cut_edge(TetMesh& mesh, std::array<TetMesh::Index, 2> edge) {
  const auto [a, b] = std::array{as_size(edge[0]), as_size(edge[1])};
  const auto middle = static_cast<TetMesh::Index>(mesh.points.size());
  mesh.points.push_back(0.5 * (mesh.points[a] + mesh.points[b]));
  mesh.tensors.push_back(0.5 * (mesh.tensors[a] + mesh.tensors[b]));
  for (std::size_t t = 0, tets = mesh.tets.size(); t < tets; ++t) {
    auto half = mesh.tets[t];
    const auto end = std::find(half.begin(), half.end(), edge[1]);
    if (end == half.end() || std::find(half.begin(), half.end(), edge[0]) == half.end()) continue;
    *end = middle;
    auto& other = mesh.tets[t];
    *std::find(other.begin(), other.end(), edge[0]) = middle;
    mesh.cell_ids.push_back(static_cast<std::int64_t>(mesh.tets.size()));
    mesh.tets.push_back(half);
  }
}

/// Where one piece has a hanging node on a face in which two meet.
TEST(StreamedPieces, AreTornWhereTheWholeIs) {
  Compared compared("torn meshes", 8);
  for (int i = 0; i < trials(80, 50); ++i) {
    SCOPED_TRACE(i);
    Random random(20261129u + static_cast<unsigned>(i));
    const TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
    const int pieces = random.integer(2, 4);
    auto files = files_of(mesh, slabs(mesh, pieces), pieces);
    if (i % 4 != 0) {
      TetMesh& file = files[as_size(random.integer(0, pieces - 1))];
      const auto tet =
          file.tets[as_size(random.integer(0, static_cast<int>(file.tets.size()) - 1))];
      cut_edge(file, {tet[0], tet[as_size(random.integer(1, 3))]});
    }
    const TetMesh whole = joined(files);
    std::vector<OuterFace> outer;
    ASSERT_TRUE(validate(whole, &outer).empty());
    const TornFaces torn = torn_faces(unmatched_faces(whole, outer), whole, outer);
    EXPECT_EQ(torn.count == 0, StreamedMesh(source_of(files)).torn_faces().count == 0);
    EXPECT_EQ(StreamedMesh(source_of(files)).torn_faces().text(), torn.text());
    compared.count(torn.count > 0);
  }
}

}  // namespace
}  // namespace tensortopo::test
