// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// What is special about a cell's degenerate points.
///
/// The stages for general position (`degenerate_points_on_face`, `degenerate_curve_in_tet`) name a
/// special position and leave it alone. `extract_degenerate_curves` settles them, in rationals; it
/// names what remains: `degenerate_on_a_surface`, `degenerate_throughout`, `no_deviator_in_cell`,
/// which are true of the field, and `points_not_told_apart`.
enum class CurveObstacle {
  zero_deviator_vertex,       ///< the deviator vanishes at a vertex: the mode is undefined there
  dependent_tensors_on_face,  ///< the deviators at three vertices are dependent
  degenerate_conic_on_face,   ///< a conic in a face's plane is degenerate, as in planes of symmetry
  coincident_points_on_face,  ///< two degenerate points in a face's plane coincide
  degenerate_point_on_edge,   ///< one is on an edge or vertex, or no 100 digits tell that it is not
  dependent_tensors_in_cell,  ///< the deviators at the four vertices are dependent
  neutral_characteristic,     ///< the characteristic tensor is neutral: the curve crosses itself
  degenerate_on_a_surface,    ///< degenerate points fill a surface, as in plane strain
  degenerate_throughout,      ///< all tensors of a cell, or of one side of a plane, are degenerate
  no_deviator_in_cell,        ///< the deviator vanishes throughout: there is no mode
  points_not_told_apart,      ///< 150 digits did not suffice, and none of these
};

/// The name that reports use.
std::string_view name_of(CurveObstacle obstacle);

/// A tensor of the input that stands for its deviator times 2^exponent, exactly.
///
/// Each vertex has a power of its own, which brings the deviator to the order of one; the weights
/// below refer to these. That moves no point and no sign.
struct ScaledTensor {
  SymmetricTensor<double> tensor{};  ///< with the exponent, exactly the deviator of the input
  int exponent = 0;                  ///< of a power of two
};

/// Directions centre + u first + v second with (u, v) in a box: a neighbourhood in the projective
/// plane. The vectors are taken as exact numbers; they are orthonormal up to rounding.
struct DirectionBox {
  /// Orthonormal up to rounding.
  Vector3<double> centre{}, first{}, second{};
  /// Bounds of u and v.
  std::array<double, 2> low{}, high{};
};

/// A point in the interior of a triangle at which the field is degenerate.
struct FacePoint {
  bool linear = true;  ///< mode 1, else mode -1
  /// Proved to contain the direction of the dominant eigenvector of this point and of no other
  /// degenerate point in the triangle's plane.
  DirectionBox box;
  std::array<Extended, 3> weights{};  ///< positive, with sum 1; rounded
  Vector3<Extended> dominant{};       ///< rounded, of length about 1
};

/// The degenerate points of the field in a triangle, or why they are not known.
struct FacePoints {
  std::vector<FacePoint> points;          ///< all that are proved to be there
  std::optional<CurveObstacle> obstacle;  ///< why some may be missing
  /// Whether linear or planar points may be missing for that; those of the other kind are all
  /// there.
  bool concerns_linear = false, concerns_planar = false;
  /// Degenerate points in the projective plane of the triangle, counted exactly: 2 or 4; 0 with
  /// an obstacle, or where the plane has one and the triangle is proved free of points.
  int in_plane = 0;
  /// Whether intervals of doubles left it to more digits.
  bool exact = false;
};

}  // namespace tensortopo
