// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {

/// Gives vertices and tetrahedra of the mesh other numbers, in the same order, in all that an
/// extraction says of them.
void renumber_level(Extraction& level, std::span<const TetMesh::Index> vertices,
                    std::span<const TetMesh::Index> tets);

/// The same of curves.
void renumber_level(CurveExtraction& level, std::span<const TetMesh::Index> vertices,
                    std::span<const TetMesh::Index> tets);

}  // namespace tensortopo
