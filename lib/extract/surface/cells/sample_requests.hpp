// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "extract/surface/cells/cell_mesher.hpp"

namespace tensortopo {

/// Puts the samples that tetrahedra ask for on the curves of their faces.
/// @return the faces that changed
template <class Scalar>
std::vector<std::size_t> add_requested_samples(const SurfaceInput<Scalar>& input,
                                               const VertexSides& sides, const TetComplex& cells,
                                               std::span<const std::size_t> asking,
                                               const MeshingStates<Scalar>& states,
                                               CellMeshes<Scalar>& meshes);

}  // namespace tensortopo
