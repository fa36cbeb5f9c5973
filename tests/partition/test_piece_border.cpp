// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Borders of pieces tell whether the pieces are those of one mesh, with all ghosts.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "tensortopo/partition/piece_border.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

std::vector<MeshPiece> cut(const TetMesh& mesh, const std::vector<std::int32_t>& owner,
                           int layers = 1) {
  std::vector<MeshPiece> pieces;
  for (int p = 0; p <= *std::max_element(owner.begin(), owner.end()); ++p)
    pieces.push_back(cut_piece(mesh, owner, p, layers));
  return pieces;
}

std::vector<PieceBorder> borders_of(const std::vector<MeshPiece>& pieces) {
  std::vector<PieceBorder> borders;
  for (const MeshPiece& piece : pieces)
    borders.push_back(border_of_numbers(numbers_of(border_of(piece))));
  return borders;
}

std::string refusal(const std::vector<MeshPiece>& pieces) {
  try {
    require_one_mesh(borders_of(pieces));
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

/// Takes a tetrahedron out of a piece.
void erase(MeshPiece& piece, std::size_t t) {
  const auto at = static_cast<std::ptrdiff_t>(t);
  piece.mesh.tets.erase(piece.mesh.tets.begin() + at);
  piece.mesh.cell_ids.erase(piece.mesh.cell_ids.begin() + at);
  piece.is_owned.erase(piece.is_owned.begin() + at);
}

RC_GTEST_PROP(PieceBorders, OfAllPiecesAreThoseOfOneMesh, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = cube_mesh(*rc::gen::inRange(1, 5));
  const auto owner = random_owners(mesh, *rc::gen::inRange(1, 9), random);
  const int layers = *rc::gen::inRange(1, 3);
  const auto pieces = cut(mesh, owner, layers);
  RC_ASSERT(require_one_mesh(borders_of(pieces)) == static_cast<std::int64_t>(mesh.tets.size()));
}

TEST(PieceBorders, TellWhatIsWrong) {
  const TetMesh mesh = cube_mesh(3);
  const auto owner = slabs(mesh, 3);
  const auto pieces = cut(mesh, owner);
  EXPECT_EQ(refusal(pieces), "");
  EXPECT_NE(refusal(cut(mesh, owner, 0)).find("it needs a layer of ghosts"), std::string::npos);
  Compared lost("ghosts taken out or without an owner", 100), twice("cells with two owners", 50);
  for (std::size_t t = 0; t < pieces[1].mesh.tets.size(); ++t) {
    const std::int64_t id = pieces[1].mesh.cell_ids[t];
    auto altered = pieces;
    if (pieces[1].is_owned[t] != 0) {
      const auto& corners = pieces[1].mesh.tets[t];
      const bool is_inner = std::all_of(corners.begin(), corners.end(), [&](Index v) {
        for (const PieceBorder& border : borders_of({pieces[0], pieces[2]}))
          for (const auto& vertex : border.vertices)
            if (vertex.id == pieces[1].vertex_ids[as_size(v)]) return false;
        return true;
      });
      erase(altered[1], t);
      if (is_inner) continue;  // then nobody else knows of it
      EXPECT_NE(refusal(altered).find("owned by no piece"), std::string::npos) << id;
      ++lost;
      continue;
    }
    erase(altered[1], t);
    EXPECT_NE(refusal(altered).find("it needs a layer of ghosts"), std::string::npos) << id;
    ++lost;
    altered = pieces;
    altered[1].is_owned[t] = 1;
    EXPECT_NE(refusal(altered).find("cell " + std::to_string(id) + " is owned by pieces"),
              std::string::npos);
    ++twice;
  }
  EXPECT_THROW(border_of_numbers(std::vector<std::int64_t>{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
