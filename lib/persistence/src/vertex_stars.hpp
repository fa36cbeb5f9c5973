// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::persistence {

/// The tetrahedra around each vertex.
class VertexStars {
 public:
  explicit VertexStars(const TetMesh& mesh);

  std::span<const TetMesh::Index> of(TetMesh::Index vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(tets_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }
  /// Those that have all of these vertices, ascending; -1 is none.
  std::vector<TetMesh::Index> around(std::span<const TetMesh::Index> vertices) const;

 private:
  const TetMesh& mesh_;
  std::vector<TetMesh::Index> tets_;
  std::vector<std::size_t> begin_;
};

/// The place of a vertex in a tetrahedron, 4 if it is none of its.
std::size_t corner_of(const TetMesh& mesh, TetMesh::Index tet, TetMesh::Index vertex);

}  // namespace tensortopo::persistence
