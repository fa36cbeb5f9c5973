// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/mesh_piece.hpp"

namespace tensortopo {

/// What others must know of a piece of a mesh to tell whether the pieces are those of one mesh, and
/// have all of its ghosts.
struct PieceBorder {
  /// A vertex of an owned tetrahedron that is one of a ghost, too, or lies on a face of one
  /// tetrahedron of the piece.
  struct Vertex {
    std::int64_t id = -1;    ///< in the whole mesh
    std::int64_t owned = 0;  ///< tetrahedra around it that the piece owns
    std::int64_t held = 0;   ///< those, and ghosts
  };

  std::vector<std::array<std::int64_t, 2>> owned_ids;  ///< as `owned_ids_of`
  std::vector<Vertex> vertices;                        ///< ascending by id
};

/// @throws std::invalid_argument as `require_sound`
PieceBorder border_of(const MeshPiece& piece);

/// A border as plain numbers, which processes can send to each other.
/// Law       `border_of_numbers(numbers_of(b))` is b.
std::vector<std::int64_t> numbers_of(const PieceBorder& border);

/// @throws std::invalid_argument unless the numbers are those of a border
PieceBorder border_of_numbers(std::span<const std::int64_t> numbers);

/// Proves of the pieces with these borders that no tetrahedron is owned by two, and that each has
/// all tetrahedra around the vertices of those that it owns (see `MeshPiece`): so far as they own
/// the whole mesh, the contract holds.
/// @return how many tetrahedra they own
/// @throws std::invalid_argument with the tetrahedron, or the vertex, and the pieces, by their
///         places in `borders`
std::int64_t require_one_mesh(std::span<const PieceBorder> borders);

}  // namespace tensortopo
