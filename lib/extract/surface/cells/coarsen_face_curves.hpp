// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/surface/cells/mesh_cells.hpp"

namespace tensortopo {

/// Samples of face curves turn out to be too dense for the triangles beside them: they were needed
/// to spread the sheet out in a chart, or follow eigenvectors that turn where the level does not.
/// Those that make needles, and that the level can do without, are taken out again.
template <class Scalar>
void coarsen_face_curves(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                         const TetComplex& cells, std::span<const CellProof<Scalar>> proofs,
                         CellMeshes<Scalar>& meshes);

}  // namespace tensortopo
