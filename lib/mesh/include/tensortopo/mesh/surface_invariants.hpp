// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// What can be said of a triangle mesh without its shape, and its area.
struct SurfaceInvariants {
  /// A connected component.
  struct Part {
    long euler_characteristic = 0;  ///< vertices - edges + triangles
    long boundary_loops = 0;        ///< closed curves of edges with one triangle
    /// Handles of an orientable part, cross-caps of another; -1 where the part is no manifold.
    long genus = 0;
    std::size_t triangles = 0;  ///< how many it has
    double area = 0;            ///< in units of the mesh, squared
    bool orientable = true;     ///< triangles could be turned to agree
    bool manifold = true;       ///< a disc or half disc around every vertex
  };

  std::size_t vertices = 0;           ///< vertices that some triangle uses
  std::size_t components = 0;         ///< connected by edges
  long boundary_loops = 0;            ///< of all parts
  long euler_characteristic = 0;      ///< of all parts
  bool orientable = true;             ///< triangles could be turned to agree with their neighbours
  bool consistently_oriented = true;  ///< they agree as they are
  bool closed = true;                 ///< no edge has only one triangle
  bool manifold = true;               ///< all parts are, and share no vertex
  double area = 0;                    ///< of all parts
  std::vector<Part> parts;            ///< in order of first triangle
  std::vector<SurfaceMesh::Index> component;  ///< of each triangle, in order of first triangle
};

/// The invariants of a triangle mesh; only `points` and `triangles` are looked at.
///
/// Two triangles are connected if a chain of triangles joins them in which neighbours share a
/// vertex. Manifold: no triangle repeats a vertex, no two have the same three, every edge has at
/// most two triangles, and the triangles around every vertex form one fan (path or cycle).
/// Boundary loops are the connected pieces of the graph of edges with exactly one triangle, and
/// orientation is compared across edges with exactly two.
///
/// Laws      (1) sums over the parts give the whole; (2) nothing but `component` and the order of
///           the parts depends on the order of the triangles, up to rounding of the areas;
///           (3) chi = 2 - 2 genus - loops for an orientable manifold part.
/// Requires  indices in range, else throws std::invalid_argument.
/// Cost      linear but for sorting the few edges at each vertex.
SurfaceInvariants surface_invariants(const SurfaceMesh& surface);

/// The component of each triangle alone, numbered as in `surface_invariants`; for vertex indices
/// known to be in range.
std::vector<SurfaceMesh::Index> surface_components(const SurfaceMesh& surface);

}  // namespace tensortopo
