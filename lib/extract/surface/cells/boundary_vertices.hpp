// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "extract/patch/patch.hpp"
#include "extract/surface/cells/prove_cells.hpp"

namespace tensortopo {

/// The vertices of patches on edges and faces of the mesh, numbered: crossings of edges first, in
/// their order (`Rows::first`), then isotropic vertices of the mesh, then samples of face curves.
struct BoundaryVertices {
  using Index = TetMesh::Index;

  std::vector<Vector3<double>> position, medium, dominant;
  std::vector<Index> of_zero;  ///< of each vertex of the mesh: its vertex if it is isotropic
  std::vector<Index> of_face;  ///< the first vertex of each face; anew when its samples change
  /// Of each face the round of meshing that changed its samples last; 0: they are as traced.
  std::vector<int> round_of_face;

  BoundaryVertex vertex(Index id, unsigned faces) const {
    const auto v = as_size(id);
    return {id, static_cast<std::uint8_t>(faces), position[v], medium[v], dominant[v]};
  }
};

/// @param round_of_face  see `BoundaryVertices`; faces are numbered in the order of their rounds
template <class Scalar>
BoundaryVertices number_boundary(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                 const TetComplex& cells, const LevelBoundary<Scalar>& boundary,
                                 std::span<const CellProof<Scalar>> proofs,
                                 std::vector<int> round_of_face);

/// Numbers the samples of the faces that a round changed, after all numbers given so far.
template <class Scalar>
void number_samples(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                    const LevelBoundary<Scalar>& boundary, std::span<const std::size_t> faces,
                    BoundaryVertices& vertices);

/// What a tetrahedron and its faces look like to meshers, in the present sampling.
template <class Scalar>
struct CellSurroundings {
  const TetComplex& cells;
  const LevelBoundary<Scalar>& boundary;
  const BoundaryVertices& vertices;
  std::size_t t;

  BoundaryVertex crossing_vertex(const TetWithCurves<Scalar>& tet, std::size_t face,
                                 const ArcEnd& end) const;
  FaceArcVertices arc_vertices(const TetWithCurves<Scalar>& tet) const;
  /// Like `loop_vertices`, without the other arcs: nearly all sheets are small.
  /// @return how many; 0 if there is no room for them
  std::size_t small_loop(const TetWithCurves<Scalar>& tet, const BoundaryLoop& loop,
                         std::span<BoundaryVertex> room) const;
};

}  // namespace tensortopo
