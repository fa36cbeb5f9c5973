// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {

/// The tetrahedra that an extraction says something of, with their vertices, in the mesh's order:
/// all that its claims depend on.
struct CrossedPart {
  TetMesh mesh;
  std::vector<TetMesh::Index> vertices;  ///< of each vertex of `mesh` the number in the mesh given
  std::vector<TetMesh::Index> tets;      ///< of each of its tetrahedra
};

CrossedPart crossed_part(const TetMesh& mesh, const Extraction& extraction);

/// result[numbers[i]] = i, and -1 elsewhere.
/// @param count  of the result
std::vector<TetMesh::Index> inverse_numbers(const std::vector<TetMesh::Index>& numbers,
                                            std::size_t count);

}  // namespace tensortopo
