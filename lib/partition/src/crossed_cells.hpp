// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Tetrahedra with the ids of their points.
struct NumberedCells {
  TetMesh cells;
  std::vector<std::int64_t> vertex_ids;  ///< ascending
};

/// `cells` of all pieces as one mesh.
struct CrossedCells {
  TetMesh mesh;
  std::vector<std::int64_t> vertex_ids;                ///< ascending
  std::vector<std::vector<TetMesh::Index>> vertex_of;  ///< of each piece: of its vertices
  std::vector<std::size_t> first_tet;                  ///< of each piece

  /// Of each tetrahedron how many have a smaller id.
  std::vector<TetMesh::Index> ranks_by_id() const;
  /// With the tetrahedra in the order of their ids.
  TetMesh sorted() const;
};

/// @param pieces  surfaces, curves (`PieceSurface`, `PieceCurves`), seams of these, or
///                `NumberedCells`
/// @throws std::invalid_argument if a vertex has two places or tensors
template <class Piece>
CrossedCells crossed_cells(std::span<const Piece> pieces);

/// The pieces own each tetrahedron of the whole mesh once, and what they say is about tetrahedra
/// that they own.
/// @param pieces  surfaces, curves (`PieceSurface`, `PieceCurves`) or seams of these
/// @throws std::invalid_argument
template <class Piece>
void require_all_cells(std::span<const Piece> pieces);

}  // namespace tensortopo
