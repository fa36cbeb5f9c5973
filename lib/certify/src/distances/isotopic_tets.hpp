// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "distances/layers.hpp"
#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// The tetrahedra with triangles in which these are not shown to be isotopic to the level. They are
/// if the sheets are discs and curves of faces are told apart by their ends, or if the level is
/// between layers of a product (`tets_of_layers`); but for tetrahedra with a vertex of zero
/// deviator, a crossing that parts of the mesh share, or triangles that come nearer to others than
/// a margin for the rounding of coordinates. proofs-check states the theorems; its checker derives
/// each hypothesis by itself, with smaller margins.
/// @param triangles  those in tetrahedra that are not undecided
/// @param coarse     where the distance is not claimed, ascending
/// @return positions in the mesh, ascending
std::vector<TetMesh::Index> tets_not_isotopic(const TetMesh& mesh, const SurfaceMesh& surface,
                                              std::span<const std::size_t> triangles,
                                              const LevelTopology& topology,
                                              std::span<const TetMesh::Index> coarse,
                                              const MovedPlaces& moved);

}  // namespace tensortopo
