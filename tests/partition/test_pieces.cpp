// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// However a mesh is cut, the surface is the same, bit for bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/fields/renumbered_mesh.hpp"
#include "tensortopo/partition/extract_in_pieces.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// What differs, in the order of the vertices and triangles too; "" if nothing does.
std::string difference(const SurfaceMesh& a, const SurfaceMesh& b) {
  if (!same_bits(a.points, b.points)) return "points";
  if (a.triangles != b.triangles) return "triangles";
  if (a.tet != b.tet) return "tetrahedra";
  if (a.component != b.component) return "components";
  if (a.carrier != b.carrier || a.carrier_vertices != b.carrier_vertices) return "carriers";
  if (!same_bits(a.normal, b.normal)) return "normals";
  if (!same_bits(a.medium_eigenvector, b.medium_eigenvector)) return "medium eigenvectors";
  if (!same_bits(a.dominant_eigenvector, b.dominant_eigenvector)) return "dominant eigenvectors";
  return same_bits(a.residual, b.residual) && same_bits(a.mode, b.mode) ? "" : "residuals";
}

RC_GTEST_PROP(Pieces, GiveTheSurfaceOfTheWholeMesh, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = field_of_any_kind(random, *rc::gen::inRange(1, 4));
  const int pieces = *rc::gen::inRange(1, 9);
  const bool is_slabs = *rc::gen::arbitrary<bool>();
  const auto owner = is_slabs ? slabs(mesh, pieces) : random_owners(mesh, pieces, random);
  const ModeValue mode = random_mode(random);
  const Extraction whole = extract_mode_surface<double>(mesh, mode);
  auto surfaces = extract_pieces(mesh, owner, pieces, mode);
  std::reverse(surfaces.begin(), surfaces.end());
  const MergedSurface merged = merge_pieces(surfaces);
  RC_CLASSIFY(!whole.surface.triangles.empty());
  RC_ASSERT(difference(whole.surface, merged.surface) == "");
  RC_ASSERT(std::equal(whole.not_embedded.begin(), whole.not_embedded.end(),
                       merged.not_embedded.begin(), merged.not_embedded.end()));
  RC_ASSERT(whole.unresolved.size() == merged.unresolved.size());
  for (std::size_t i = 0; i < merged.unresolved.size(); ++i) {
    RC_ASSERT(merged.unresolved[i].cell_id == whole.unresolved[i].tet);
    RC_ASSERT(merged.unresolved[i].reason == whole.unresolved[i].reason);
  }
}

// Ids above 2^31, and pieces that number their vertices and tetrahedra as they like.
RC_GTEST_PROP(Pieces, NumberTheirVerticesAsTheyLike, ()) {
  constexpr std::int64_t kFar = std::int64_t{1} << 40;
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = field_of_any_kind(random, 2);
  const auto owner = random_owners(mesh, 3, random);
  const ModeValue mode = random_mode(random);
  const Extraction whole = extract_mode_surface<double>(mesh, mode);
  std::vector<PieceSurface> surfaces;
  for (int p = 0; p < 3; ++p) {
    const MeshPiece piece = cut_piece(mesh, owner, p);
    const RenumberedMesh other = renumbered_mesh(piece.mesh, random);
    MeshPiece shuffled{other.mesh, {}, {}, piece.whole_tets};
    for (const Index v : other.vertices)
      shuffled.vertex_ids.push_back(kFar + piece.vertex_ids[as_size(v)]);
    for (std::size_t t = 0; t < other.tets.size(); ++t) {
      shuffled.mesh.cell_ids[t] = kFar + piece.mesh.cell_ids[as_size(other.tets[t])];
      shuffled.is_owned.push_back(piece.is_owned[as_size(other.tets[t])]);
    }
    surfaces.push_back(extract_piece(shuffled, mode));
  }
  const MergedSurface merged = merge_pieces(surfaces);
  RC_ASSERT(same_bits(merged.surface.points, whole.surface.points));
  RC_ASSERT(merged.surface.triangles == whole.surface.triangles);
  RC_ASSERT(same_bits(merged.surface.normal, whole.surface.normal));
  for (std::size_t i = 0; i < merged.cell_ids.size(); ++i) {
    RC_ASSERT(merged.cell_ids[i] == kFar + whole.surface.tet[i]);
    RC_ASSERT(merged.surface.tet[i] == -1);
  }
  for (std::size_t v = 0; v < merged.carrier_ids.size(); ++v)
    for (std::size_t k = 0; k < 4; ++k) {
      const Index c = whole.surface.carrier_vertices[v][k];
      RC_ASSERT(merged.carrier_ids[v][k] == (c < 0 ? -1 : kFar + c));
    }
}

TEST(ExtractInPieces, GivesTheSameSurfaceWithDenserCells) {
  Random random(20261125);
  for (const char* text : {"0", "1/2", "-99/100"}) {
    const TetMesh mesh = field_of_any_kind(random, 3);
    const ModeValue mode = ModeValue::parse(text);
    ExtractOptions options;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      options.density.push_back(static_cast<float>(random.integer(1, 2)));
    const Extraction whole = extract_mode_surface<double>(mesh, mode, options);
    for (const int pieces : {1, 2, 5}) {
      const Extraction again = extract_in_pieces(mesh, mode, pieces, options);
      EXPECT_EQ(difference(whole.surface, again.surface), "") << text << ' ' << pieces;
      EXPECT_EQ(whole.statistics.tets_crossed, again.statistics.tets_crossed);
      EXPECT_EQ(whole.unresolved.size(), again.unresolved.size());
      EXPECT_EQ(whole.not_embedded, again.not_embedded) << text << ' ' << pieces;
    }
  }
  TetMesh mesh = field_of_any_kind(random, 1);
  EXPECT_THROW(extract_in_pieces(mesh, ModeValue::parse("0"), 0), std::invalid_argument);
  for (const TetMesh::Index v : mesh.tets[0]) mesh.tensors[as_size(v)] = {2, 2, 2, 0, 0, 0};
  const auto undefined = extract_mode_surface<double>(mesh, ModeValue::parse("0"), {});
  EXPECT_GT(undefined.statistics.tets_undefined, 0u);
  EXPECT_EQ(extract_in_pieces(mesh, ModeValue::parse("0"), 3).statistics.tets_undefined,
            undefined.statistics.tets_undefined);
}

/// What ghosts are told and tell is the same in all pieces; if it were not, that would be noticed.
TEST(PieceMessages, AreCompared) {
  Random random(20261126);
  Compared compared("messages between pieces", 100);
  Compared refused("altered messages", 20);
  for (int trial = 0; trial < 6; ++trial) {
    const TetMesh mesh = field_of_any_kind(random, 3);
    const auto owner = random_owners(mesh, 3, random);
    const ModeValue mode = ModeValue::parse(kModes[static_cast<std::size_t>(trial)]);
    const auto pieces = extract_pieces(mesh, owner, 3, mode);
    ASSERT_NO_THROW(merge_pieces(pieces));
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      for (std::size_t m = 0; m < pieces[p].heard.size(); ++m) compared.count();
      for (std::size_t m = 0; m < pieces[p].heard.size(); m += 1 + pieces[p].heard.size() / 3) {
        auto altered = pieces;
        if (m % 2 == 0)
          ++altered[p].heard[m].digest;
        else
          altered[p].heard.erase(altered[p].heard.begin() + static_cast<std::ptrdiff_t>(m));
        EXPECT_THROW(merge_pieces(altered), PiecesDiffer);
        refused.count();
      }
    }
  }
}

class WrongPieces : public testing::Test {
 protected:
  void SetUp() override {
    mesh_ = cube_mesh(3);
    fill_with_smooth_tensors(mesh_, 20261124);
    owner_ = slabs(mesh_, 3);
  }
  PieceSurface piece(int p) const { return extract_piece(cut_piece(mesh_, owner_, p), mode_); }
  static std::string refusal(const std::vector<PieceSurface>& pieces) {
    try {
      merge_pieces(pieces);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  }

  TetMesh mesh_;
  std::vector<std::int32_t> owner_;
  const ModeValue mode_ = ModeValue::parse("0");
};

TEST_F(WrongPieces, OneIsMissing) {
  EXPECT_EQ(refusal({piece(0), piece(1), piece(2)}), "");
  EXPECT_NE(refusal({piece(0), piece(2)}).find("a piece is missing"), std::string::npos);
  EXPECT_NE(refusal({}), "");
}

// The cells in question hold no triangles and touch no others.
TEST_F(WrongPieces, OneWithoutASurfaceIsMissingOrGivenTwice) {
  const TetMesh plain = cube_mesh(1);
  const std::size_t cells = mesh_.tets.size();
  const auto first = static_cast<Index>(mesh_.points.size());
  for (const auto& p : plain.points) {
    mesh_.points.push_back({p.x + 100, p.y, p.z});
    mesh_.tensors.push_back({2, -1, -1, 0, 0, 0});
  }
  for (auto tet : plain.tets) {
    for (Index& v : tet) v += first;
    mesh_.tets.push_back(tet);
  }
  owner_.resize(mesh_.tets.size(), 3);
  ASSERT_TRUE(piece(3).surface.triangles.empty());
  EXPECT_EQ(refusal({piece(0), piece(1), piece(2), piece(3)}), "");
  EXPECT_EQ(refusal({piece(0), piece(1), piece(2)}),
            "pieces: they own " + std::to_string(cells) + " of the " +
                std::to_string(mesh_.tets.size()) + " cells of the whole mesh: a piece is missing");
  EXPECT_NE(refusal({piece(0), piece(3), piece(1), piece(2), piece(3)}).find("two pieces"),
            std::string::npos);
}

TEST_F(WrongPieces, OneIsCountedDifferently) {
  PieceSurface other = piece(1);
  ++other.whole_tets;
  EXPECT_NE(refusal({piece(0), other, piece(2)}).find("not of one mesh"), std::string::npos);
  other = piece(1);
  other.owned_ids[0][0] = std::numeric_limits<std::int64_t>::min();
  EXPECT_NE(refusal({piece(0), other, piece(2)}).find("not in order"), std::string::npos);
  other = piece(1);
  other.owned_ids.clear();
  EXPECT_NE(refusal({piece(0), other, piece(2)}).find("does not own it"), std::string::npos);
  MeshPiece cut = cut_piece(mesh_, owner_, 0);
  cut.whole_tets = 1;
  EXPECT_THROW(extract_piece(cut, mode_), std::invalid_argument);
  cut = cut_piece(mesh_, owner_, 0);
  cut.mesh.tensors.pop_back();
  EXPECT_THROW(extract_piece(cut, mode_), std::invalid_argument);
}

TEST_F(WrongPieces, OneIsGivenTwice) {
  EXPECT_NE(refusal({piece(0), piece(1), piece(1), piece(2)}).find("is owned by two pieces"),
            std::string::npos);
}

TEST_F(WrongPieces, OneIsOfAnotherMesh) {
  const PieceSurface first = piece(0);
  for (auto& t : mesh_.tensors) t.xy += 0x1p-40;
  EXPECT_NE(refusal({first, piece(1), piece(2)}).find("not of one mesh"), std::string::npos);
}

TEST_F(WrongPieces, OneHasNoGhosts) {
  const PieceSurface alone = extract_piece(cut_piece(mesh_, owner_, 1, 0), mode_);
  EXPECT_NE(refusal({piece(0), alone, piece(2)}), "");
}

TEST_F(WrongPieces, IdsRepeatOrAreNegative) {
  MeshPiece piece = cut_piece(mesh_, owner_, 0);
  piece.vertex_ids[1] = piece.vertex_ids[0];
  EXPECT_THROW(extract_piece(piece, mode_), std::invalid_argument);
  piece.vertex_ids[1] = -1;
  EXPECT_THROW(extract_piece(piece, mode_), std::invalid_argument);
  piece = cut_piece(mesh_, owner_, 0);
  piece.is_owned.pop_back();
  EXPECT_THROW(extract_piece(piece, mode_), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
