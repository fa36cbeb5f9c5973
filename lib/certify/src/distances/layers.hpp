// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// A vertex moved by its reach in a tetrahedron, back and ahead.
using MovedPlaces =
    std::function<std::array<Vector3<double>, 2>(TetMesh::Index tet, SurfaceMesh::Index vertex)>;

/// The tetrahedra among some in which the triangles with corners between their places behind the
/// level and ahead of it are embedded as the layers of a product, with a margin for rounding. The
/// level lies between them, so it is isotopic to the triangles, whatever its sheets are:
/// proofs-check states the theorem, and its checker derives the hypotheses by itself.
/// @param triangles  those in tetrahedra that are not undecided
/// @param tets       without isotropic vertices, and where the distance is claimed; ascending
/// @return ascending
std::vector<TetMesh::Index> tets_of_layers(const SurfaceMesh& surface,
                                           std::span<const std::size_t> triangles,
                                           std::span<const TetMesh::Index> tets,
                                           const MovedPlaces& moved);

}  // namespace tensortopo
