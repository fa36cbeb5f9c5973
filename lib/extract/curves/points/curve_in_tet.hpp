// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/extract/curve_points.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// A degenerate point on the boundary of a tetrahedron.
struct BoundaryPoint {
  std::size_t face = 0;                  ///< the vertex opposite
  std::array<std::size_t, 3> corners{};  ///< vertices of the face, in the order of its tensors
  FacePoint point;
};

/// A place on the curve inside a tetrahedron.
struct CurveSample {
  std::array<Extended, 4> weights{};  ///< sum 1; rounded
  Vector3<Extended> dominant{};       ///< about unit
};

/// A stretch of the degenerate curve through a tetrahedron, from boundary loop point to boundary
/// loop point.
struct CurvePiece {
  std::size_t begin = 0, end = 0;  ///< positions in the list of boundary loop points
  std::vector<CurveSample> inner;  ///< between them, in order
};

struct CurveInTet {
  std::vector<CurvePiece> pieces;
  std::optional<CurveObstacle> obstacle;
};

/// How the degenerate curve joins the points in which it meets the faces of a tetrahedron.
///
/// The degenerate tensors of a field of rank 4 are those along e e^T - (|e|^2 / 3) I with
/// e.N e = 0, N being the characteristic tensor: a conic in the projective plane of e. Seen from a
/// point c inside that conic (c.N c < 0 where det N < 0) its points have a cyclic order. The curve
/// enters or leaves the tetrahedron where the conic passes a boundary loop point, as the derivative
/// of the one weight that changes sign tells, so each entering point is joined to the next one.
/// Every sign (of det N, c.N c, the orientation of neighbours around c, the derivatives) is
/// certain: intervals of doubles first, then of 150 digits. A loop that meets no face does not
/// exist: two traceless forms in three variables have a common zero, hence the conic meets every
/// plane.
///
/// Samples between boundary loop points are placed on the conic by projection from c, at most
/// `largest_turn` radians of turning of the dominant eigenvector apart.
///
/// @param boundary loop  all boundary loop points of one kind, linear or planar; no two on one edge
/// of the tetrahedron
CurveInTet degenerate_curve_in_tet(const std::array<ScaledTensor, 4>& tensors,
                                   const std::vector<BoundaryPoint>& boundary, double largest_turn);

}  // namespace tensortopo
