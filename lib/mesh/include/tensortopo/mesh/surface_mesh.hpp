// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// Where a vertex of an extracted surface lies in the tetrahedral mesh.
enum class Carrier : std::uint8_t { edge, face, tet, vertex };

/// An extracted surface: triangles over shared vertices, with what is known at each vertex.
/// Vertices are one for each point: two tetrahedra that meet use the same vertex.
///
/// Where the level runs through a vertex of the tetrahedral mesh exactly, each edge from there to
/// larger modes is crossed at its end: these vertices of the surface are different ones at one
/// place, and triangles between them have no area.
///
/// Where triangles would form several fans each has a vertex of its own: at crossings of an edge in
/// which parts of the mesh touch, or which left-out tetrahedra part; where the mode is undefined,
/// at isotropic vertices of the mesh and between two of them. At the latter both
/// eigenvectors and the residual are zero, and the normal is the mean of the gradients along the
/// fan (or zero).
struct SurfaceMesh {
  using Index = std::int32_t;  ///< of a vertex

  std::vector<Vector3<double>> points;  ///< coordinates
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise seen from the larger mode

  // One per vertex.
  std::vector<Carrier> carrier;                        ///< what kind of simplex holds the vertex
  std::vector<Index> carrier_id;                       ///< which one
  /// The vertices, in the tetrahedral mesh, of the simplex that holds the vertex, ascending; -1
  /// fills up. This is the vertex's key: two tetrahedra that meet there agree on it.
  std::vector<std::array<Index, 4>> carrier_vertices;
  std::vector<Vector3<double>> medium_eigenvector;     ///< unit, sign arbitrary
  std::vector<Vector3<double>> dominant_eigenvector;   ///< unit, sign arbitrary
  /// Unit: along the sum of unit gradients, one for each tetrahedron with triangles there (or these).
  std::vector<Vector3<double>> normal;
  std::vector<double> mode;                            ///< the mode asked for
  std::vector<double> residual;  ///< mode (or other invariant) of the field there less `mode`
  /// Of surfaces of another invariant than the mode, which have no `mode` and no eigenvectors: the
  /// value asked for.
  std::vector<double> value;

  // One per triangle.
  std::vector<Index> tet;        ///< index of the tetrahedron that holds the triangle
  std::vector<Index> component;  ///< connected component, numbered in order of first triangle
};

}  // namespace tensortopo
