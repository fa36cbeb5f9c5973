// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A part of a piece's surface is that of a mesh with the part's tetrahedra only.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/restrict_piece.hpp"

namespace tensortopo::test {
namespace {

using Id = std::int64_t;
using Triangle = std::array<double, 9>;

ExtractOptions keeping_proofs() {
  ExtractOptions options;
  options.keep_topology = true;
  return options;
}

Triangle corners_of(const SurfaceMesh& surface, std::size_t i) {
  Triangle corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& p = surface.points[as_size(surface.triangles[i][k])];
    corners[3 * k] = p.x, corners[3 * k + 1] = p.y, corners[3 * k + 2] = p.z;
  }
  return corners;
}

/// Triangles by their tetrahedra, in their order.
std::map<Id, std::vector<Triangle>> by_tet(const MergedSurface& merged) {
  std::map<Id, std::vector<Triangle>> result;
  for (std::size_t i = 0; i < merged.cell_ids.size(); ++i)
    result[merged.cell_ids[i]].push_back(corners_of(merged.surface, i));
  return result;
}

std::vector<Id> shuffled(std::size_t count, Random& random) {
  std::vector<Id> ids(count);
  std::iota(ids.begin(), ids.end(), Id{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(ids[i - 1],
              ids[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  return ids;
}

/// The part's tetrahedra with ids and vertices that are shuffled.
PartNumbers numbers_of_part(const TetMesh& mesh, const std::vector<std::int32_t>& part, int which,
                            Random& random) {
  PartNumbers numbers;
  for (std::size_t t = 0; t < part.size(); ++t)
    if (part[t] == which) numbers.tets.push_back({static_cast<Id>(t), 0});
  const auto tets = shuffled(numbers.tets.size(), random);
  for (std::size_t i = 0; i < tets.size(); ++i) numbers.tets[i][1] = tets[i];
  const auto vertices = shuffled(mesh.points.size(), random);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    numbers.vertices.push_back({static_cast<Id>(v), vertices[v]});
  return numbers;
}

/// Each fan of triangles around a vertex of the surface has a vertex of its own.
void require_one_fan_each(const SurfaceMesh& surface) {
  std::map<std::array<SurfaceMesh::Index, 2>, int> sides;  // directed
  std::vector<int> corners(surface.points.size()), inner(surface.points.size());
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int count = ++sides[{t[k], t[(k + 1) % 3]}];
      EXPECT_EQ(count, 1);
      ++corners[as_size(t[k])];
    }
  for (const auto& [side, count] : sides)
    if (sides.contains({side[1], side[0]})) ++inner[as_size(side[0])];
  // A fan of n triangles has n inner edges at its vertex if it is closed, else n - 1.
  for (std::size_t v = 0; v < corners.size(); ++v) {
    EXPECT_GT(corners[v], 0);
    EXPECT_LE(corners[v] - inner[v], 1) << "vertex " << v;
  }
}

void require_parts(std::uint64_t seed, Compared& compared) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  TetMesh mesh = cube_mesh(random.integer(2, 3));
  fill_with_smooth_tensors(mesh, seed);
  const ModeValue mode = random_mode(random);
  const auto owner = slabs(mesh, 2);
  const auto pieces = extract_pieces(mesh, owner, 2, mode, keeping_proofs());
  const MergedSurface whole = merge_pieces(pieces);
  const auto of_whole = by_tet(whole);
  std::size_t triangles = 0;
  auto part = random_owners(mesh, 2, random);
  for (int p = 0; p < 2; ++p)
    for (int q = 0; q < 2; ++q) {
      auto own = part;
      for (std::size_t t = 0; t < own.size(); ++t)
        if (owner[t] != p) own[t] = -1;
      const PartNumbers numbers = numbers_of_part(mesh, own, q, random);
      if (numbers.tets.empty()) continue;
      const MergedSurface merged =
          merge_pieces(std::array{restrict_piece(pieces[static_cast<std::size_t>(p)], numbers)});
      EXPECT_EQ(merged.whole_tets, static_cast<Id>(numbers.tets.size()));
      std::map<Id, std::vector<Triangle>> expected;
      for (const auto& [tet, id] : numbers.tets)
        if (const auto found = of_whole.find(tet); found != of_whole.end())
          expected[id] = found->second;
      EXPECT_TRUE(by_tet(merged) == expected);
      require_one_fan_each(merged.surface);
      EXPECT_NO_THROW(certify(merged, mode));
      triangles += merged.cell_ids.size();
    }
  EXPECT_EQ(triangles, whole.cell_ids.size());
  compared.count(triangles > 20);
}

TEST(RestrictedPieces, HaveTheTrianglesOfTheWhole) {
  Compared compared("parts with triangles", 3);
  for (int i = 0; i < trials(8, 4); ++i) require_parts(20261126u + static_cast<unsigned>(i), compared);
}

TEST(RestrictedPieces, OfAllTetrahedraAreThePiece) {
  TetMesh mesh = cube_mesh(3);
  fill_with_smooth_tensors(mesh, 20261124);
  const ModeValue mode = ModeValue::parse("0");
  const auto pieces = extract_pieces(mesh, slabs(mesh, 1), 1, mode, keeping_proofs());
  PartNumbers same;
  for (Id t = 0; t < static_cast<Id>(mesh.tets.size()); ++t) same.tets.push_back({t, t});
  for (Id v = 0; v < static_cast<Id>(mesh.points.size()); ++v) same.vertices.push_back({v, v});
  const auto bytes = [&](const PieceSurface& piece) {
    const CertifiedLevel level = certify(merge_pieces(std::array{piece}), mode);
    return certificate_bytes({}, std::span(&level, 1), {}, CertificateEncoding::json);
  };
  EXPECT_GT(pieces[0].surface.triangles.size(), 50U);
  EXPECT_TRUE(bytes(restrict_piece(pieces[0], same)) == bytes(pieces[0]));
}

void require_refused(const PieceSurface& piece, const PartNumbers& numbers,
                     const std::string& text) {
  try {
    restrict_piece(piece, numbers);
    ADD_FAILURE() << "not refused: " << text;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(RestrictedPieces, RefuseNumbersThatAreNone) {
  TetMesh mesh = cube_mesh(3);
  fill_with_smooth_tensors(mesh, 20261124);
  const auto owner = slabs(mesh, 2);
  const auto pieces = extract_pieces(mesh, owner, 2, ModeValue::parse("0"), keeping_proofs());
  Random random(1);
  const PartNumbers good = numbers_of_part(mesh, owner, 0, random);
  EXPECT_NO_THROW(restrict_piece(pieces[0], good));
  require_refused(pieces[1], good, "is not owned by its piece");
  PartNumbers bad = good;
  bad.tets[1][1] = bad.tets[0][1];
  require_refused(pieces[0], bad, "has the id of another");
  bad = good;
  bad.vertices[0][1] = -1;
  require_refused(pieces[0], bad, "a negative id");
  bad = good;
  bad.vertices.clear();
  require_refused(pieces[0], bad, "has no number in the part");
}

}  // namespace
}  // namespace tensortopo::test
