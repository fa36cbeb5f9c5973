// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/extract/curve_points.hpp"

namespace tensortopo {

/// All points in the interior of a triangle at which the mode is 1 or -1, and no others.
///
/// In the projective plane that the triangle spans there are two such points, or four if the binary
/// cubic det(x M + y N) has three real zeros, M and N spanning the tensors across; the sign of its
/// discriminant tells. Each is found in floating point and then proved: Krawczyk's operator maps a
/// box around it into itself, so that it holds exactly one zero of the two quadratic forms e.M e
/// and e.N e. The boxes are disjoint and as many as counted, and in them the three weights have
/// strict signs. First in intervals of doubles; then, where the tensors are nearly dependent, in these
/// of rows reduced by each other (`CellRows`); what both leave open goes to 100 digits and intervals
/// of 150.
///
/// Laws      (1) of a kind that no obstacle concerns, the points are exactly those in the triangle,
///           none on its sides; (2) changing all signs exchanges linear and planar points; (3) the
///           result depends on the three tensors in their order only: order them by global ids.
/// Requires  finite entries.
FacePoints degenerate_points_on_face(const std::array<ScaledTensor, 3>& tensors);

}  // namespace tensortopo
