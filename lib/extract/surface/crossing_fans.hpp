// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "extract/surface/cells/mesh_cells.hpp"

namespace tensortopo {

/// Vertices that crossings of edges have besides their own: where fans of triangles meet in nothing
/// but a crossing, each but the first has a copy, so that the surface is a manifold.
struct CrossingCopies {
  using Index = TetMesh::Index;
  std::vector<Index> original;  ///< of each copy
  /// Of a vertex in a tetrahedron of another fan than the first: which copy it has.
  std::map<std::pair<std::size_t, Index>, std::size_t> of;
};

template <class Scalar>
CrossingCopies crossing_copies(const ExtractOptions& options, const TetComplex& cells,
                               const CellMeshes<Scalar>& meshes);

}  // namespace tensortopo
