// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tensortopo/extract/curve_points.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The two kinds of degenerate tensors.
enum class Degeneracy {
  linear,  ///< mode 1: the two smaller eigenvalues are equal
  planar,  ///< mode -1: the two larger ones
};

/// A tetrahedron whose degenerate curves are not known.
struct UnresolvedCurve {
  TetMesh::Index tet;      ///< position in the mesh
  CurveObstacle obstacle;  ///< why
};

/// What the extraction did, for reports.
struct CurveStatistics {
  std::size_t tets_screened_out = 0;  ///< proved empty by Lode angles
  /// Hold lines; of those around a line along an edge or in a face, one.
  std::size_t tets_crossed = 0;
  std::size_t faces = 0;        ///< counted without screening
  std::size_t faces_exact = 0;  ///< of these, left to more digits
  std::size_t face_points = 0;  ///< found on them
  /// Time of each stage, in seconds.
  double seconds_faces = 0, seconds_tets = 0, seconds_stitch = 0;
};

/// The degenerate curves of a field, and what is known of them.
struct CurveExtraction {
  CurveMesh curves;                         ///< the polylines
  std::vector<UnresolvedCurve> unresolved;  ///< by tetrahedron
  /// Other tetrahedra in which a curve may be in special position, settled in rationals, with what
  /// is special; by tetrahedron.
  std::vector<UnresolvedCurve> special;
  CurveStatistics statistics;  ///< what was done
};

/// The curves of linear (or planar) degenerate points of the piecewise linear field.
///
/// On every face all degenerate points are found and no others, and in every tetrahedron they are
/// joined as the curve joins them; both by proofs, see `degenerate_points_on_face` and
/// `degenerate_curve_in_tet`. Vertices are shared by construction: each carries the vertex, edge,
/// face or tetrahedron that it lies in.
///
/// Special positions are settled in rationals. A curve through an edge or a vertex has a vertex
/// there, shared by all around; along an edge or in a face (as in planes of symmetry) it runs once.
/// With three independent tensors in a tetrahedron, or none at a vertex, it consists of straight
/// lines. With a neutral characteristic tensor it crosses itself in a junction. A single point at
/// which curves only touch the cells around is no curve, and left out.
///
/// A tetrahedron is listed where degenerate points fill more than curves: a surface, as in plane
/// strain (`degenerate_on_a_surface`; lines along the common eigenvector are extracted all the
/// same), or all of it (`degenerate_throughout`); where it has no deviator (`no_deviator_in_cell`);
/// or where 150 digits do not separate points. Elsewhere each component is closed or ends on the
/// boundary, at an isotropic point, or at a listed tetrahedron. The exception are curves of
/// even multiplicity, along which the eigenvectors do not turn over: in special position they may
/// end, or one may branch into two, as they can where a general curve cannot.
///
/// Sampling is by the turning of the dominant eigenvector.
/// @pre the mesh is valid, see `validate`
/// The result does not depend on the number of threads, nor (but for the numbers that it names) on
/// how the mesh is numbered.
CurveExtraction extract_degenerate_curves(const TetMesh& mesh, Degeneracy kind,
                                          const ExtractOptions& options = {});

}  // namespace tensortopo
