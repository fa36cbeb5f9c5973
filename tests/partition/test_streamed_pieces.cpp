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

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

/// The pieces as files have them: with points of their own, numbered anew.
std::vector<TetMesh> files_of(const TetMesh& mesh, const std::vector<std::int32_t>& owner,
                              int pieces) {
  std::vector<TetMesh> files(as_size(pieces));
  for (int p = 0; p < pieces; ++p) {
    TetMesh& file = files[as_size(p)];
    std::vector<Index> number(mesh.points.size(), -1);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      if (owner[t] != p) continue;
      auto corners = mesh.tets[t];
      for (Index& v : corners) {
        Index& n = number[as_size(v)];
        if (n < 0) {
          n = static_cast<Index>(file.points.size());
          file.points.push_back(mesh.points[as_size(v)]);
          file.tensors.push_back(mesh.tensors[as_size(v)]);
        }
        v = n;
      }
      file.cell_ids.push_back(static_cast<std::int64_t>(file.tets.size()));
      file.tets.push_back(corners);
    }
  }
  return files;
}

/// All files one after the other, points in one place as one.
TetMesh joined(const std::vector<TetMesh>& files) {
  TetMesh whole;
  for (const TetMesh& file : files) {
    std::vector<Index> number;
    for (std::size_t v = 0; v < file.points.size(); ++v) {
      const auto same = std::find(whole.points.begin(), whole.points.end(), file.points[v]);
      number.push_back(static_cast<Index>(same - whole.points.begin()));
      if (same != whole.points.end()) continue;
      whole.points.push_back(file.points[v]);
      whole.tensors.push_back(file.tensors[v]);
    }
    for (auto corners : file.tets) {
      for (Index& v : corners) v = number[as_size(v)];
      whole.cell_ids.push_back(static_cast<std::int64_t>(whole.tets.size()));
      whole.tets.push_back(corners);
    }
  }
  return whole;
}

PieceSource source_of(const std::vector<TetMesh>& files) {
  return {static_cast<std::int32_t>(files.size()),
          [&files](std::int32_t p) { return files[as_size(p)]; }};
}

void require_bits_of_whole(std::uint64_t seed, Compared& compared) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
  const int pieces = random.integer(1, 7);
  const auto owner =
      random.integer(0, 1) == 0 ? slabs(mesh, pieces) : random_owners(mesh, pieces, random);
  const auto files = files_of(mesh, owner, pieces);
  const TetMesh whole = joined(files);
  const ModeValue mode = random_mode(random);
  ExtractOptions options;
  options.keep_topology = true;
  const StreamedSurface streamed = extract_streamed(source_of(files), mode, options);
  EXPECT_EQ(streamed.points, whole.points.size());
  EXPECT_EQ(streamed.tets, whole.tets.size());
  EXPECT_EQ(streamed.field_sha256, field_sha256(whole));

  Extraction extraction = extract_mode_surface<double>(whole, mode, options);
  const SurfaceMesh &a = extraction.surface, &b = streamed.merged.surface;
  compared.count(!a.triangles.empty());
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_TRUE(a.points.empty() || std::memcmp(a.points.data(), b.points.data(),
                                              a.points.size() * sizeof(a.points[0])) == 0);
  EXPECT_TRUE(a.triangles == b.triangles && a.tet == b.tet && a.component == b.component);
  const CertifiedLevel of_whole = certify(whole, mode, extraction);
  const CertifiedLevel of_pieces = certify(streamed.merged, mode);
  const auto json = CertificateEncoding::json;
  EXPECT_TRUE(certificate_bytes({}, std::span(&of_whole, 1), whole, json) ==
              certificate_bytes({}, std::span(&of_pieces, 1), {}, json));
}

TEST(StreamedPieces, HaveTheSurfaceAndTheCertificateOfTheWhole) {
  Compared compared("surfaces with triangles", 3);
  for (int i = 0; i < trials(8); ++i)
    require_bits_of_whole(20261124u + static_cast<unsigned>(i), compared);
}

std::string refusal(const std::vector<TetMesh>& files) {
  try {
    extract_streamed(source_of(files), ModeValue::parse("0"));
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
}

}  // namespace
}  // namespace tensortopo::test
