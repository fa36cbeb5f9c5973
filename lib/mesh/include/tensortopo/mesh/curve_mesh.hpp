// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Extracted curves: polylines over shared vertices, with what is known at each vertex.
///
/// A line is what one cell holds of a curve in its interior: a tetrahedron, or where the curve runs
/// there, a face or an edge. It ends on the boundary of the cell, at a junction or where the mode
/// is undefined. The lines of a component follow each other, the last vertex of one being the first
/// of the next, and all run the same way; at a junction, where other than two lines end, another
/// row of lines may begin.
struct CurveMesh {
  using Index = SurfaceMesh::Index;  ///< of a vertex

  std::vector<Vector3<double>> points;    ///< coordinates
  std::vector<std::vector<Index>> lines;  ///< two or more vertices each

  // One per vertex.
  std::vector<Carrier> carrier;                        ///< the cell that holds it
  std::vector<std::array<Index, 4>> carrier_vertices;  ///< as in SurfaceMesh
  std::vector<Vector3<double>>
      dominant_eigenvector;  ///< unit, sign arbitrary; 0 if there is no mode
  std::vector<double> mode;  ///< 1 or -1
  /// Positive where the tensors across the dominant eigenvector have a wedge, negative where they
  /// have a trisector, in units of 1 / length^2.
  ///
  /// With p, q, e right-handed and e the dominant eigenvector, and dT(x) the derivative of the
  /// tensor along x: the determinant of the derivatives along p and q of the components
  /// (p.T p - q.T q) / 2 and p.T q, over |T|^2, |T| being the norm of the deviator. For planar
  /// fields this is the invariant of T. Delmarcelle and L. Hesselink (The topology of symmetric,
  /// second-order tensor fields, 1994); here it is taken in the plane across e. At most 2^1000, and at
  /// least -2^1000.
  std::vector<double> separation;
  /// sqrt(1 - mode^2) of the field at the vertex as rounded: three times the angle to the nearest
  /// degenerate tensor, to first order. (1 - |mode| is quadratic in it and would always be 0.)
  std::vector<double> residual;

  // One per line.
  std::vector<Index> tet;        ///< index of the tetrahedron that holds the line, or of one around
  std::vector<Index> component;  ///< numbered in order of first line
};

/// What can be said of curves as a whole.
struct CurveInvariants {
  std::size_t vertices = 0;           ///< that some line uses
  double length = 0;                  ///< of all lines, in units of the mesh
  std::size_t components = 0;         ///< connected ones
  std::size_t closed_components = 0;  ///< those without an end
};

/// Counted from the points and lines alone.
/// Requires indices in range, else throws std::invalid_argument.
CurveInvariants curve_invariants(const CurveMesh& curves);

}  // namespace tensortopo
