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
      random.integer(0, 1) == 0 ? slabs(mesh, pieces) : random_owners(mesh, pieces, random);
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
    extract_streamed(StreamedMesh(source_of(files)), ModeValue::parse("0"));
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
