// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

inline constexpr double kFeatureAngle = 25;  ///< degrees

enum class EdgeKind {
  boundary,  ///< edges of one triangle
  crease,    ///< edges of two, where the surface bends by `kFeatureAngle` or more
};

/// The edges of a kind, each once, as its first triangle has it, by triangles: the same lines
/// however vertices are numbered. Edges are distinguished by the numbers of their vertices. Memory
/// is linear; `vtkFeatureEdges` of VTK 9.1, which does the same, asks for n^2 / 200 numbers for n
/// points, more than there is from a million on.
std::vector<std::array<SurfaceMesh::Index, 2>> feature_edges(const SurfaceMesh& surface,
                                                             EdgeKind kind);

}  // namespace tensortopo
