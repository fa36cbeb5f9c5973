// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Vertices of the edges of a tetrahedron: edge e joins `kTetEdges[e]`.
inline constexpr std::array<std::array<int, 2>, 6> kTetEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The edge that joins two vertices of a tetrahedron.
constexpr int tet_edge(int i, int j) {
  constexpr std::array<std::array<int, 4>, 4> table{
      {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};
  return table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
}

/// The edges and faces of some of a mesh's tetrahedra, each once, in the order of their ids.
struct TetComplex {
  using Index = TetMesh::Index;  ///< of a vertex, edge, face or tetrahedron

  std::vector<Index> tets;                         ///< which tetrahedra, ascending
  std::vector<std::array<Index, 2>> edges;         ///< vertices, ascending
  std::vector<std::array<Index, 3>> faces;         ///< vertices, ascending
  std::vector<std::array<Index, 3>> face_edges;    ///< edges 01, 02, 12 of each face
  std::vector<std::array<Index, 2>> face_tets;     ///< positions in `tets`; second may be -1
  std::vector<std::array<Index, 6>> tet_edges;     ///< as `kTetEdges`
  std::vector<std::array<Index, 4>> tet_faces;     ///< face i is opposite vertex i
};

/// Collects the edges and faces of the tetrahedra listed. In parallel; the result does not depend
/// on the number of threads.
TetComplex tet_complex(const TetMesh& mesh, std::span<const TetMesh::Index> tets);

}  // namespace tensortopo
