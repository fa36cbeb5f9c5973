// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// The tetrahedra with triangles in which these are not shown to be isotopic to the level: those
/// with a sheet that is no disc, a vertex of zero deviator, closed curves of a face beside other
/// curves, a crossing that parts of the mesh share, or triangles that come nearer to others than a
/// margin for the rounding of coordinates. proofs-check states the theorem; its checker derives each
/// hypothesis by itself, with smaller margins.
/// @param triangles  those in tetrahedra that are not undecided
/// @return positions in the mesh, ascending
std::vector<TetMesh::Index> tets_not_isotopic(const TetMesh& mesh, const SurfaceMesh& surface,
                                              std::span<const std::size_t> triangles,
                                              const LevelTopology& topology);

}  // namespace tensortopo
