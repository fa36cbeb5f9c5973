// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Pieces of degenerate curves that do not fit are refused with the place.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "pieces_of_curves.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

template <class Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const PiecesDiffer& e) {
    return "differ: " + std::string(e.what());
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

class WrongCurvePieces : public testing::Test {
 protected:
  void SetUp() override {
    mesh_ = cube_mesh(3);
    fill_with_normal_tensors(mesh_, 20261124);
    owner_ = slabs(mesh_, 3);
    parts_ = curve_pieces(mesh_, owner_, 3, Degeneracy::linear);
  }
  /// By pieces and by seams alike.
  static void expect_refused(const std::vector<PieceCurves>& parts, const std::string& text) {
    std::vector<CurveSeam> seams;
    for (const PieceCurves& part : parts) seams.push_back(curve_seam_of(part));
    for (const std::string& said : {refusal_of([&] { merge_curve_pieces(parts); }),
                                    refusal_of([&] { join_curve_seams(seams); })}) {
      EXPECT_NE(said.find(text), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }

  TetMesh mesh_;
  std::vector<std::int32_t> owner_;
  std::vector<PieceCurves> parts_;
};

TEST_F(WrongCurvePieces, OneIsMissingOrGivenTwice) {
  EXPECT_EQ(refusal_of([&] { merge_curve_pieces(parts_); }), "");
  expect_refused({parts_[0], parts_[2]}, "a piece is missing");
  expect_refused({parts_[0], parts_[1], parts_[1], parts_[2]}, "is owned by two pieces");
  expect_refused({}, "there are none");
  auto other = parts_;
  ++other[1].whole_tets;
  expect_refused(other, "not of one mesh");
}

TEST_F(WrongCurvePieces, OneHasCurvesOfAnotherKindOrMesh) {
  const MeshPiece piece = cut_piece(mesh_, owner_, 1);
  expect_refused({parts_[0], extract_curve_piece(piece, Degeneracy::planar), parts_[2]},
                 "extract one kind from all");
  for (auto& t : mesh_.tensors) t.xy += 0x1p-40;
  const PieceCurves other = extract_curve_piece(cut_piece(mesh_, owner_, 1), Degeneracy::linear);
  expect_refused({parts_[0], other, parts_[2]}, "pieces: ");
}

TEST_F(WrongCurvePieces, OneHasOtherVertices) {
  Compared refused("altered vertices", 10);
  for (std::size_t v = 0; v < parts_[1].around.size(); ++v) {
    if (parts_[1].is_shared[v] == 0) continue;
    auto parts = parts_;
    parts[1].curves.separation[v] += 1;
    expect_refused(parts, "differ: ");
    parts = parts_;
    ++parts[1].around[v];
    expect_refused(parts, "curves differ at the simplex of vertices ");
    ++refused;
  }
}

TEST_F(WrongCurvePieces, NumbersAreNone) {
  const auto numbers = numbers_of(curve_seam_of(parts_[1]));
  EXPECT_EQ(numbers_of(curve_seam_of_numbers(numbers)), numbers);
  Compared refused("altered numbers", 20);
  for (std::size_t size = 0; size < numbers.size(); size += 1 + numbers.size() / 25) {
    EXPECT_THROW(curve_seam_of_numbers(std::span(numbers).first(size)), std::invalid_argument);
    ++refused;
  }
  auto longer = numbers;
  longer.push_back(0);
  EXPECT_THROW(curve_seam_of_numbers(longer), std::invalid_argument);
  CurveSeam wrong = curve_seam_of(parts_[1]);
  wrong.vertices.at(0).component = static_cast<Index>(wrong.components.size());
  EXPECT_THROW(curve_seam_of_numbers(numbers_of(wrong)), std::invalid_argument);
  wrong = curve_seam_of(parts_[1]);
  wrong.components.at(0).first_cell[0] = static_cast<Index>(wrong.vertex_ids.size());
  EXPECT_THROW(curve_seam_of_numbers(numbers_of(wrong)), std::invalid_argument);
}

TEST_F(WrongCurvePieces, VerticesOfAPieceAreNotInOrder) {
  MeshPiece piece = cut_piece(mesh_, owner_, 0);
  std::swap(piece.vertex_ids[0], piece.vertex_ids[1]);
  EXPECT_THROW(owned_curves(piece, Degeneracy::linear, {}), std::invalid_argument);
}

/// A field with degenerate tensors on an axis only, which runs along edges.
TetMesh mesh_around_an_axis() {
  TetMesh mesh = cube_mesh(2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    const double x = (p.x - 1) - (p.y - 1) / 2, y = 7 * (p.y - 1) / 8;
    mesh.tensors[v] = {x * x, y * y, 2 + p.z, x * y, 0, 0};
  }
  return mesh;
}

/// What ghosts hold around a line along an edge decides what becomes of the line.
TEST(LinesAlongEdges, AreRefusedWhereGhostsHoldOtherwise) {
  const TetMesh mesh = mesh_around_an_axis();
  const auto is_on_axis = [&](Index v) {
    return mesh.points[as_size(v)].x == 1 && mesh.points[as_size(v)].y == 1;
  };
  Compared refused("ghosts that hold otherwise", 4);
  Compared altered("altered messages", 10);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (std::count_if(mesh.tets[t].begin(), mesh.tets[t].end(), is_on_axis) != 2) continue;
    std::vector<std::int32_t> owner(mesh.tets.size(), 0);
    owner[t] = 1;
    const auto parts = curve_pieces(mesh, owner, 2, Degeneracy::linear);
    ASSERT_EQ(refusal_of([&] { merge_curve_pieces(parts); }), "");
    const auto expect_refused = [&](const PieceCurves& other) {
      const std::string said = refusal_of([&] { merge_curve_pieces(std::array{parts[0], other}); });
      EXPECT_NE(said.find(" was not treated alike"), std::string::npos) << said;
      EXPECT_EQ(said, refusal_of([&] {
                  join_curve_seams(std::array{curve_seam_of(parts[0]), curve_seam_of(other)});
                }));
    };
    for (std::size_t m = 0; m < parts[1].heard.size(); ++m, ++altered) {
      PieceCurves other = parts[1];
      ++other.heard[m].digest;
      expect_refused(other);
    }
    // Degenerate throughout.
    MeshPiece piece = cut_piece(mesh, owner, 1);
    const auto own = as_size(std::find(piece.is_owned.begin(), piece.is_owned.end(), 1) -
                             piece.is_owned.begin());
    const auto& corners = piece.mesh.tets[own];
    for (const auto& tet : piece.mesh.tets) {
      const auto is_common = [&](Index v) {
        return std::find(corners.begin(), corners.end(), v) != corners.end();
      };
      if (std::count_if(tet.begin(), tet.end(), is_common) != 2 ||
          std::any_of(tet.begin(), tet.end(), [&](Index v) {
            return is_common(v) && !is_on_axis(static_cast<Index>(piece.vertex_ids[as_size(v)]));
          }))
        continue;
      MeshPiece wrong = piece;
      for (const Index v : tet)
        if (!is_common(v)) wrong.mesh.tensors[as_size(v)] = {0, 0, 3, 0, 0, 0};
      expect_refused(extract_curve_piece(wrong, Degeneracy::linear));
      ++refused;
    }
  }
}

/// Vertices that no owned tetrahedron has.
std::vector<std::size_t> ghost_vertices(const MeshPiece& piece) {
  std::vector<char> is_owned(piece.vertex_ids.size(), 0);
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t)
    if (piece.is_owned[t] != 0)
      for (const Index v : piece.mesh.tets[t]) is_owned[as_size(v)] = 1;
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < is_owned.size(); ++v)
    if (is_owned[v] == 0) result.push_back(v);
  return result;
}

struct GhostCounts {
  std::size_t refused = 0, harmless = 0;
};

/// A ghost that was told otherwise is refused, or changes nothing.
void alter_ghosts(const TetMesh& mesh, Random& random, GhostCounts& counts) {
  const int pieces = 4;
  const auto owner = random_owners(mesh, pieces, random);
  for (const Degeneracy kind : kDegeneracies) {
    const CurveExtraction whole = extract_degenerate_curves(mesh, kind);
    auto parts = curve_pieces(mesh, owner, pieces, kind);
    MeshPiece piece = cut_piece(mesh, owner, 1);
    const auto ghosts = ghost_vertices(piece);
    if (ghosts.empty()) continue;
    const auto which = random.integer(0, static_cast<int>(ghosts.size()) - 1);
    auto& tensor = piece.mesh.tensors[ghosts[as_size(which)]];
    tensor =
        random.integer(0, 3) == 0 ? SymmetricTensor<double>{1, 1, 1, 0, 0, 0} : random.tensor();
    parts[1] = extract_curve_piece(piece, kind);
    const std::string said = refusal_of([&] {
      EXPECT_EQ(curve_difference(whole, merge_curve_pieces(parts)), "");
      ++counts.harmless;
    });
    EXPECT_EQ(refusal_of([&] { join_curve_seams(sent_curve_seams(parts)); }).empty(), said.empty())
        << said;
    if (said.empty()) continue;
    EXPECT_EQ(said.find("differ: pieces: "), 0u) << said;
    ++counts.refused;
  }
}

TEST(AlteredGhosts, AreRefusedOrChangeNothing) {
  GhostCounts counts;
  const int fields = std::min(trials(20), 400);
  for (int field = 0; field < fields; ++field) {
    Random random(20261127u + static_cast<unsigned>(field));
    TetMesh mesh = cube_mesh(3);
    fill_with_normal_tensors(mesh, 20261127u + static_cast<unsigned>(field));
    if (field % 4 == 3) mesh = special_mesh(MeshKind::mirrored, random);
    mesh.cell_ids.resize(mesh.tets.size());
    alter_ghosts(mesh, random, counts);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GE(counts.refused, as_size(fields) / 4);
  EXPECT_GE(counts.harmless, 1u);
}

}  // namespace
}  // namespace tensortopo::test
