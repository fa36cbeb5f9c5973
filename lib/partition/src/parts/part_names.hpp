// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What a part of a mesh calls what it has.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/restrict_piece.hpp"

namespace tensortopo {

/// What the part calls an id of the whole mesh.
class PartNames {
 public:
  /// @param pairs  as `PartNumbers` has them
  /// @param what  these are, for messages
  /// @throws std::invalid_argument if an id is negative, or repeats
  PartNames(const std::vector<std::array<std::int64_t, 2>>& pairs, const char* what);

  bool has(std::int64_t whole) const { return find(whole) != pairs_.end(); }
  /// @throws std::invalid_argument if it has none
  std::int64_t of(std::int64_t whole) const;

 private:
  std::vector<std::array<std::int64_t, 2>>::const_iterator find(std::int64_t whole) const;

  std::vector<std::array<std::int64_t, 2>> pairs_;
  const char* what_;
};

/// The part's ids of its tetrahedra as runs.
/// @param owned_ids  of the piece
/// @throws std::invalid_argument if the piece does not own one of them
std::vector<std::array<std::int64_t, 2>> part_ids(
    std::span<const std::array<std::int64_t, 2>> owned_ids, const PartNumbers& numbers);

/// Gives vertices and tetrahedra of some cells the part's ids, and the vertices numbers in the order
/// of these.
/// @return of each vertex its new number
std::vector<TetMesh::Index> name_cells_anew(TetMesh& cells, std::vector<std::int64_t>& vertex_ids,
                                            const PartNames& tets, const PartNames& vertices);

}  // namespace tensortopo
