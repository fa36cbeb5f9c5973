// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Seams alone give the components of the whole surface, their order and their numbers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/partition/seam_numbers.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;
using Key = std::pair<std::array<std::int64_t, 4>, std::int32_t>;

/// As another process gets them.
std::vector<SurfaceSeam> sent_seams(const std::vector<PieceSurface>& pieces) {
  std::vector<SurfaceSeam> seams;
  for (const PieceSurface& piece : pieces)
    seams.push_back(seam_of_numbers(numbers_of(seam_of(piece))));
  return seams;
}

/// By tetrahedron and place in it: the component of each triangle.
using Components = std::map<std::pair<std::int64_t, int>, Index>;

Components components_of(const PieceSurface& piece, const std::vector<Index>& numbers) {
  Components result;
  std::map<std::int64_t, int> next;
  const auto own = surface_components(piece.surface);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const std::int64_t tet = piece.cells.cell_ids[as_size(piece.surface.tet[i])];
    result[{tet, next[tet]++}] = numbers[as_size(own[i])];
  }
  return result;
}

/// What is wrong with what seams say of a whole surface; "" if nothing is.
std::string difference(const std::vector<PieceSurface>& pieces, const SurfaceMesh& whole) {
  const auto seams = sent_seams(pieces);
  const JoinedSeams joined = join_seams(seams);
  const SurfaceInvariants known = surface_invariants(whole);
  if (joined.components.size() != known.parts.size()) return "how many components";
  for (std::size_t c = 0; c < known.parts.size(); ++c) {
    const auto& found = joined.components[c];
    const auto& part = known.parts[c];
    const std::string which = " of component " + std::to_string(c);
    if (found.triangles != static_cast<std::int64_t>(part.triangles)) return "triangles" + which;
    if (found.euler_characteristic != part.euler_characteristic) return "Euler number" + which;
    if (found.boundary_loops != part.boundary_loops) return "loops" + which;
  }
  const auto total = joined.total();
  if (total.vertices != static_cast<std::int64_t>(known.vertices)) return "vertices";
  if (total.euler_characteristic != known.euler_characteristic) return "Euler number";
  Components expected, found;
  std::map<Index, int> next;
  for (std::size_t i = 0; i < whole.tet.size(); ++i)
    expected[{whole.tet[i], next[whole.tet[i]]++}] = whole.component[i];
  for (std::size_t p = 0; p < pieces.size(); ++p)
    found.merge(components_of(pieces[p], joined.numbers[p]));
  return expected == found ? "" : "numbers of components";
}

RC_GTEST_PROP(SurfaceSeams, GiveTheComponentsOfTheWhole, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = field_of_any_kind(random, *rc::gen::inRange(1, 4));
  const int pieces = *rc::gen::inRange(1, 9);
  const auto owner =
      *rc::gen::arbitrary<bool>() ? slabs(mesh, pieces) : random_owners(mesh, pieces, random);
  const ModeValue mode = random_mode(random);
  const Extraction whole = extract_mode_surface<double>(mesh, mode);
  auto surfaces = extract_pieces(mesh, owner, pieces, mode);
  std::reverse(surfaces.begin(), surfaces.end());
  RC_CLASSIFY(!whole.surface.triangles.empty());
  RC_CLASSIFY(!whole.unresolved.empty());
  RC_ASSERT(difference(surfaces, whole.surface) == "");
  RC_ASSERT(difference(surfaces, merge_pieces(surfaces).surface) == "");
}

/// Surfaces of all modes, also with isotropic vertices, and pieces that have no more than a vertex
/// in common.
TEST(SurfaceSeams, GiveTheComponentsAtEveryMode) {
  const int fields = trials(4, 2);
  Compared surfaces("surfaces of several components", static_cast<std::size_t>(fields));
  for (int field = 0; field < fields; ++field) {
    Random random(20261127u + static_cast<unsigned>(field));
    const TetMesh mesh = field_of_any_kind(random, 1 + field % 3, 6);
    const int pieces = random.integer(2, 12);
    const auto owner =
        field % 2 == 0 ? random_owners(mesh, pieces, random) : bisected(mesh, pieces);
    for (const char* text : kModes) {
      const ModeValue mode = ModeValue::parse(text);
      const Extraction whole = extract_mode_surface<double>(mesh, mode);
      const auto parts = extract_pieces(mesh, owner, pieces, mode);
      ASSERT_EQ(difference(parts, whole.surface), "") << "field " << field << ", mode " << text;
      const bool is_several =
          !whole.surface.component.empty() &&
          *std::max_element(whole.surface.component.begin(), whole.surface.component.end()) > 0;
      surfaces.count(is_several);
    }
  }
}

/// Where a tetrahedron has no proof, sides beside it have no partner, and are on the border.
TEST(SurfaceSeams, KnowBordersBesideTetrahedraWithoutAProof) {
  Compared left_out("sides on the seam beside a tetrahedron without a proof", 4);
  for (int field = 0; field < 2; ++field) {
    Random random(20261130u + static_cast<unsigned>(field));
    TetMesh mesh = cube_mesh(2);
    fill_with_smooth_tensors(mesh, 20261130u + static_cast<unsigned>(field));
    const auto flat = as_size(random.integer(0, static_cast<int>(mesh.tets.size()) - 1));
    for (const Index v : mesh.tets[flat]) mesh.tensors[as_size(v)] = {1, 0, -1, 0, 0, 0};
    const auto owner = random_owners(mesh, 5, random);
    const ModeValue mode = ModeValue::parse("0");
    const Extraction whole = extract_mode_surface<double>(mesh, mode);
    const auto parts = extract_pieces(mesh, owner, 5, mode);
    ASSERT_EQ(difference(parts, whole.surface), "") << "field " << field;
    for (const PieceSurface& part : parts)
      for (const auto& side : seam_of(part).sides)
        left_out.count(std::any_of(whole.unresolved.begin(), whole.unresolved.end(),
                                   [&](const auto& cell) { return cell.tet == side.ghost_id; }));
  }
}

std::set<Key> keys_of(const PieceSurface& piece) {
  std::set<Key> keys;
  for (const auto& triangle : piece.surface.triangles)
    for (const Index v : triangle) {
      std::array<std::int64_t, 4> ids{-1, -1, -1, -1};
      std::size_t count = 0;
      for (const Index c : piece.surface.carrier_vertices[as_size(v)])
        if (c >= 0) ids[count++] = piece.vertex_ids[as_size(c)];
      std::sort(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(count));
      keys.insert({ids, piece.ordinals[as_size(v)]});
    }
  return keys;
}

/// Pairs of pieces that have a face in common.
std::set<std::pair<int, int>> neighbours(const TetMesh& mesh,
                                         const std::vector<std::int32_t>& owner) {
  std::map<std::array<Index, 3>, int> first;
  std::set<std::pair<int, int>> result;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<Index, 3> face{};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != i) face[n++] = mesh.tets[t][k];
      std::sort(face.begin(), face.end());
      const auto [known, is_new] = first.try_emplace(face, owner[t]);
      if (!is_new) result.insert(std::minmax(known->second, int{owner[t]}));
    }
  return result;
}

/// A vertex that two pieces have is on the seams of both, also if no face lies between them.
TEST(SurfaceSeams, HaveAllVerticesThatPiecesShare) {
  Compared shared("vertices that pieces share", 500);
  Compared without_face("vertices of pieces without a common face", 30);
  for (int field = 0; field < 8; ++field) {
    Random random(20261128u + static_cast<unsigned>(field));
    const TetMesh mesh = field_of_any_kind(random, 2, 6);
    const int pieces = 12;
    const auto owner = random_owners(mesh, pieces, random);
    const auto near = neighbours(mesh, owner);
    const auto parts = extract_pieces(mesh, owner, pieces, random_mode(random));
    std::vector<std::set<Key>> keys, on_seam;
    for (const PieceSurface& part : parts) {
      keys.push_back(keys_of(part));
      auto& seam = on_seam.emplace_back();
      for (const auto& v : seam_of(part).vertices) seam.insert({v.carrier_ids, v.ordinal});
      ASSERT_TRUE(std::includes(keys.back().begin(), keys.back().end(), seam.begin(), seam.end()));
    }
    for (int p = 0; p < pieces; ++p)
      for (int q = p + 1; q < pieces; ++q)
        for (const Key& key : keys[as_size(p)]) {
          if (!keys[as_size(q)].contains(key)) continue;
          ASSERT_TRUE(on_seam[as_size(p)].contains(key) && on_seam[as_size(q)].contains(key));
          ++shared;
          without_face.count(!near.contains({p, q}));
        }
  }
}

/// Of a level across slabs the seam grows as a curve does.
TEST(SurfaceSeams, AreSmall) {
  const auto sizes = [](int cubes) {
    TetMesh mesh = cube_mesh(cubes);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      mesh.tensors[v] = {1, mesh.points[v].y, -1, 0, 0, 0};
    const auto piece = extract_piece(cut_piece(mesh, slabs(mesh, 2), 0), ModeValue::parse("0.1"));
    return std::pair(piece.surface.triangles.size(), numbers_of(seam_of(piece)).size());
  };
  const auto small = sizes(6), large = sizes(24);
  EXPECT_GT(large.first, 12 * small.first);
  EXPECT_LT(large.second, 6 * small.second);
}

class WrongSeams : public testing::Test {
 protected:
  void SetUp() override {
    mesh_ = cube_mesh(3);
    fill_with_normal_tensors(mesh_, 20261124);
    owner_ = slabs(mesh_, 3);
    for (int p = 0; p < 3; ++p) seams_.push_back(seam(p));
  }
  SurfaceSeam seam(int p, const char* mode = "0") const {
    return seam_of(extract_piece(cut_piece(mesh_, owner_, p), ModeValue::parse(mode)));
  }
  static std::string refusal(const std::vector<SurfaceSeam>& seams) {
    try {
      join_seams(seams);
    } catch (const PiecesDiffer& e) {
      return "differ: " + std::string(e.what());
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  }
  static bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  }

  TetMesh mesh_;
  std::vector<std::int32_t> owner_;
  std::vector<SurfaceSeam> seams_;
};

TEST_F(WrongSeams, OneIsMissingOrGivenTwice) {
  EXPECT_EQ(refusal(seams_), "");
  EXPECT_TRUE(has(refusal({seams_[0], seams_[2]}), "a piece is missing"));
  EXPECT_TRUE(has(refusal({seams_[0], seams_[1], seams_[1], seams_[2]}), "is owned by two pieces"));
  EXPECT_TRUE(has(refusal({}), "there are none"));
  auto other = seams_;
  ++other[1].whole_tets;
  EXPECT_TRUE(has(refusal(other), "not of one mesh"));
}

TEST_F(WrongSeams, OneIsOfAnotherModeOrMesh) {
  EXPECT_TRUE(has(refusal({seams_[0], seam(1, "1/10"), seams_[2]}), "differ: "));
  for (auto& t : mesh_.tensors) t.xy += 0x1p-40;
  EXPECT_TRUE(has(refusal({seams_[0], seam(1), seams_[2]}), "differ: "));
}

TEST_F(WrongSeams, OneHasOtherVerticesSidesOrMessages) {
  Compared refused("altered seams", 30);
  const auto expect = [&](const char* text, const auto& alter) {
    auto seams = seams_;
    alter(seams[1]);
    EXPECT_TRUE(has(refusal(seams), text)) << refusal(seams);
    ++refused;
  };
  for (std::size_t v = 0; v < seams_[1].vertices.size(); v += 5)
    expect("they differ at the simplex", [&](SurfaceSeam& s) { ++s.vertices[v].digest; });
  for (std::size_t i = 0; i < seams_[1].sides.size(); i += 5) {
    const std::string cell = std::to_string(seams_[1].sides[i].cell_id);
    expect((" and " + cell + " do not meet").c_str(), [&](SurfaceSeam& s) {
      s.sides.erase(s.sides.begin() + static_cast<std::ptrdiff_t>(i));
    });
  }
  for (std::size_t m = 0; m < seams_[1].heard.size(); m += 5)
    expect("was not treated alike", [&](SurfaceSeam& s) { ++s.heard[m].digest; });
}

TEST_F(WrongSeams, NumbersAreNone) {
  const auto numbers = numbers_of(seams_[1]);
  EXPECT_EQ(numbers_of(seam_of_numbers(numbers)), numbers);
  Compared refused("altered numbers", 20);
  for (std::size_t size = 0; size < numbers.size(); size += 1 + numbers.size() / 25) {
    EXPECT_THROW(seam_of_numbers(std::span(numbers).first(size)), std::invalid_argument);
    ++refused;
  }
  auto longer = numbers;
  longer.push_back(0);
  EXPECT_THROW(seam_of_numbers(longer), std::invalid_argument);
  SurfaceSeam wrong = seams_[1];
  wrong.vertices[0].component = static_cast<Index>(wrong.components.size());
  EXPECT_THROW(seam_of_numbers(numbers_of(wrong)), std::invalid_argument);
  wrong = seams_[1];
  wrong.sides[0].to = -1;
  EXPECT_THROW(seam_of_numbers(numbers_of(wrong)), std::invalid_argument);
  wrong = seams_[1];
  wrong.vertices[0].border = static_cast<Index>(wrong.vertices.size());
  EXPECT_THROW(seam_of_numbers(numbers_of(wrong)), std::invalid_argument);
}

/// A surface of the piece's mesh, however it was extracted.
TEST(OwnedSurface, IsThatOfThePiece) {
  Random random(20261129);
  Compared compared("pieces with triangles", 4);
  for (int trial = 0; trial < 4; ++trial) {
    const TetMesh mesh = field_of_any_kind(random, 2);
    const auto owner = random_owners(mesh, 3, random);
    const ModeValue mode = random_mode(random);
    ExtractOptions options;
    options.keep_samples = true;
    for (int p = 0; p < 3; ++p) {
      const MeshPiece piece = cut_piece(mesh, owner, p);
      const PieceSurface expected = extract_piece(piece, mode, options);
      const PieceSurface found =
          owned_surface(piece, extract_mode_surface<double>(piece.mesh, mode, options).surface);
      EXPECT_EQ(found.surface.triangles, expected.surface.triangles);
      EXPECT_EQ(found.ordinals, expected.ordinals);
      EXPECT_EQ(found.ghost_across, expected.ghost_across);
      EXPECT_EQ(found.owned_ids, expected.owned_ids);
      compared.count(!found.surface.triangles.empty());
    }
    MeshPiece turned = cut_piece(mesh, owner, 0);
    std::swap(turned.vertex_ids[0], turned.vertex_ids[1]);
    EXPECT_THROW(owned_surface(turned, {}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace tensortopo::test
