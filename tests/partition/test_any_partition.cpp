// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// However a mesh is numbered and cut, the bits of its surface and the bytes of its certificate.
#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <string>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"

namespace tensortopo::test {
namespace {

std::string certificate_of(const CertifiedLevel& level, const TetMesh& mesh) {
  return certificate_bytes({}, std::span(&level, 1), mesh, CertificateEncoding::json);
}

template <class T>
void expect_bits(const std::vector<T>& a, const std::vector<T>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0) << what;
}

TEST(AnyNumberingAndPartition, GivesTheSameBits) {
  const int fields = trials(1);
  Compared surfaces("surfaces with triangles", static_cast<std::size_t>(fields));
  for (int field = 0; field < fields; ++field) {
    Random random(20261124u + static_cast<unsigned>(field));
    TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      mesh.cell_ids[t] = static_cast<std::int64_t>(t);
    const RenumberedMesh other = renumbered_mesh(mesh, random);
    const int pieces = random.integer(2, 16), kind = random.integer(0, 2);
    const auto owner = owners_of_kind(kind, other.mesh, pieces, random);
    const PreparedField<double> prepared(mesh);
    ExtractOptions options;
    options.keep_topology = true;
    // One field alone is tried at every third mode.
    for (std::size_t m = 0; m < kModes.size(); m += fields == 1 ? 3 : 1) {
      const char* text = kModes[m];
      const std::string where = "field " + std::to_string(field) + ", mode " + text + ", " +
                                std::to_string(pieces) + " pieces of kind " + std::to_string(kind);
      const ModeValue mode = ModeValue::parse(text);
      Extraction whole = extract_mode_surface(prepared, mode, options);
      std::vector<PieceSurface> parts;
      for (int p = 0; p < pieces; ++p)
        parts.push_back(extract_piece(piece_of_renumbered(other, owner, p), mode, options));
      const MergedSurface merged = merge_pieces(parts);
      expect_bits(whole.surface.points, merged.surface.points, where);
      expect_bits(whole.surface.triangles, merged.surface.triangles, where);
      expect_bits(whole.surface.normal, merged.surface.normal, where);
      expect_bits(whole.surface.tet, merged.surface.tet, where);
      expect_bits(whole.surface.component, merged.surface.component, where);
      expect_bits(whole.surface.medium_eigenvector, merged.surface.medium_eigenvector, where);
      expect_bits(whole.surface.residual, merged.surface.residual, where);
      const CertifiedLevel a = certify(prepared, mode, whole), b = certify(merged, mode);
      EXPECT_EQ(certificate_of(a, mesh), certificate_of(b, {})) << where;
      if (HasFailure()) return;
      surfaces.count(!merged.surface.triangles.empty());
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
