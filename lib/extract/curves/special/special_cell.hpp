// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "extract/curves/points/curve_in_tet.hpp"
#include "extract/curves/points/exact_direction.hpp"
#include "tensortopo/scalar/extended.hpp"

/// \file
/// Degenerate curves in special position, cell by cell: an edge, a face or a tetrahedron is given
/// with the points on its boundary and yields what is in its interior. So a curve through an edge,
/// along an edge or in a face is found there, once for all cells around.
///
/// The weights w of the vertices make degenerate tensors where sum w_i D_i = s (e e^T - |e|^2 I /
/// 3). With r independent deviators out of n the set has n - r dimensions more than that of the
/// directions e, which are: for r = 1 one or none; for r = 2 at most three; for r = 3 at most four,
/// or one and all those across it (a common eigenvector); for r = 4 a conic, or two lines.

namespace tensortopo {

/// A degenerate point, or one isotropic, in the interior of a cell.
struct SpecialPoint {
  unsigned support = 0;                     ///< the vertices of positive weight, one bit each
  std::array<Extended, 4> weights{};        ///< of these vertices, with sum 1; rounded
  Vector3<Extended> dominant{};             ///< rounded; zero isotropic
  std::optional<ExactDirection> direction;  ///< of the dominant eigenvector; none isotropic
};

/// A stretch of the curve in the interior of a cell.
struct SpecialPiece {
  /// Positions in the list of the boundary's points, or behind it of the cell's own ones.
  std::array<std::size_t, 2> ends{};
  std::vector<CurveSample> inner;  ///< between them, in order
  /// Whether the direction is across an eigenvector that the tensors in a face share.
  bool across_axis = false;
};

struct SpecialCell {
  std::vector<SpecialPoint> points;
  std::vector<SpecialPiece> pieces;
  /// The eigenvector that all the tensors share, for three independent ones.
  std::optional<Vector3<Rational>> axis;
  /// Why there is more than curves, or not all of them.
  std::optional<CurveObstacle> obstacle;
};

/// What the interior of a cell holds of the curve of one kind.
///
/// @param boundary loop    all points of the kind, and isotropic, on the boundary of the cell
/// @param faces  of a tetrahedron: what is known of the face opposite each vertex
/// @param crossings  of a face: where the curve in a tetrahedron beside it would cross a conic in
/// the
///                   face; apart from each other
/// Between consecutive points of the boundary the curve is inside or outside altogether, which one
/// place on it tells: by 150 digits, as no sign is close to zero there. What is zero is decided in
/// rationals, or known from the boundary.
template <std::size_t Vertices>
SpecialCell special_cell(const std::array<ScaledTensor, Vertices>& tensors, bool linear,
                         std::span<const SpecialPoint> boundary, double largest_turn,
                         std::span<const SpecialCell* const> faces = {},
                         std::span<const ExactDirection> crossings = {});

/// Where the curve of a tetrahedron with independent tensors and neutral characteristic tensor
/// crosses itself: the kernel of that tensor. Zero for all others.
Vector3<Rational> crossing_of(const std::array<ScaledTensor, 4>& tensors);

}  // namespace tensortopo
