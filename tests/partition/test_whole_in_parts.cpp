// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Parts know the components of the whole, and their certificates do not depend on who extracted.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/certify/extract_within.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/partition/surface_seam.hpp"
#include "tensortopo/partition/whole_in_parts.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

/// A part of all tetrahedra that a piece owns, with the ids of the whole in reverse.
PartNumbers reversed_numbers(const MeshPiece& piece) {
  PartNumbers numbers;
  for (std::size_t t = piece.is_owned.size(); t-- > 0;)
    if (piece.is_owned[t] != 0)
      numbers.tets.push_back(
          {piece.mesh.cell_ids[t], static_cast<std::int64_t>(numbers.tets.size())});
  for (std::size_t v = piece.vertex_ids.size(); v-- > 0;)
    numbers.vertices.push_back(
        {piece.vertex_ids[v], static_cast<std::int64_t>(numbers.vertices.size())});
  return numbers;
}

/// Of each triangle, by its corners.
std::map<std::array<double, 9>, Index> by_corners(const SurfaceMesh& surface,
                                                  const std::vector<Index>& values) {
  std::map<std::array<double, 9>, Index> result;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    std::array<double, 9> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = surface.points[as_size(surface.triangles[i][k])];
      corners[3 * k] = p.x, corners[3 * k + 1] = p.y, corners[3 * k + 2] = p.z;
    }
    result[corners] = values[i];
  }
  return result;
}

void require_components(unsigned seed, Compared& compared) {
  Random random(seed);
  TetMesh mesh = cube_mesh(4);
  fill_with_smooth_tensors(mesh, seed);
  const ModeValue mode = random_mode(random);
  const auto owner = random_owners(mesh, 3, random);
  const auto pieces = extract_pieces(mesh, owner, 3, mode);
  const MergedSurface whole = merge_pieces(pieces);
  const auto expected = by_corners(whole.surface, whole.surface.component);
  std::vector<SurfaceSeam> seams;
  for (const PieceSurface& piece : pieces) seams.push_back(seam_of(piece));
  const JoinedSeams joined = join_seams(seams);
  std::size_t triangles = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::vector<Index> components;
    for (const Index c : surface_components(pieces[p].surface))
      components.push_back(joined.numbers[p][as_size(c)]);
    const PartNumbers numbers = reversed_numbers(cut_piece(mesh, owner, static_cast<int>(p)));
    const SurfacePart part = part_of(pieces[p], numbers, components);
    for (const auto& [corners, component] : by_corners(part.surface.surface, part.whole_component)) {
      const auto found = expected.find(corners);
      ASSERT_NE(found, expected.end());
      EXPECT_EQ(component, found->second);
      ++triangles;
    }
    if (components.empty()) continue;
    components.pop_back();
    EXPECT_THROW(part_of(pieces[p], numbers, components), std::invalid_argument);
  }
  EXPECT_EQ(triangles, expected.size());
  compared.count(joined.components.size() > 1);
}

TEST(WholeInParts, PartsHaveTheComponentsOfTheWhole) {
  Compared compared("surfaces of several components", 2);
  for (int i = 0; i < trials(8, 4); ++i)
    require_components(20261127u + static_cast<unsigned>(i), compared);
}

/// What a piece's extraction proves serves as well as what `extract_piece` keeps.
TEST(WholeInParts, CertificatesAreOfAnyExtractionOfThePiece) {
  TetMesh mesh = cube_mesh(4);
  fill_with_smooth_tensors(mesh, 20261124);
  const ModeValue mode = ModeValue::parse("1/10");
  const MeshPiece piece = cut_piece(mesh, slabs(mesh, 2), 0);
  ExtractOptions options;
  options.keep_topology = options.keep_samples = true;
  const auto certificate = [&](const PieceSurface& surface) {
    const std::vector<Index> components = surface_components(surface.surface);
    EXPECT_GT(components.size(), 50u);
    return certificate_bytes(part_of(surface, reversed_numbers(piece), components), mode, {});
  };
  const std::string expected = certificate(extract_piece(piece, mode, options));
  EXPECT_EQ(expected, certificate(owned_surface(
                          piece, mode, extract_mode_surface<double>(piece.mesh, mode, options),
                          true)));
  // A distance that any surface has: nothing is sampled more densely.
  const auto within = extract_within(piece.mesh, mode, 1e9, options);
  EXPECT_EQ(expected, certificate(owned_surface(piece, mode, within.extraction, true)));
  options.keep_topology = false;
  const auto without = extract_within(piece.mesh, mode, 1e9, options);
  EXPECT_TRUE(without.extraction.topology.edges.empty());
  const PieceSurface bare = owned_surface(piece, mode, without.extraction, false);
  EXPECT_FALSE(bare.topology.has_value());
}

}  // namespace
}  // namespace tensortopo::test
