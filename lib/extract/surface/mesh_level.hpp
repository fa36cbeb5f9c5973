// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/surface/cells/mesh_cells.hpp"

namespace tensortopo {

/// The level in some tetrahedra: what is proved of it, and its triangles.
template <class Scalar>
struct MeshedLevel {
  std::vector<CellProof<Scalar>> proofs;
  CellMeshes<Scalar> meshes;
};

/// Time of each stage, in seconds.
struct StageSeconds {
  double edges = 0, faces = 0, tets = 0;
};

/// The stages from the edges to the triangles, in this order: crossings, face curves, proofs,
/// patches.
/// @param seconds  the times are added to these
template <class Scalar>
MeshedLevel<Scalar> mesh_level(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                               const TetComplex& cells, StageSeconds& seconds);

}  // namespace tensortopo
