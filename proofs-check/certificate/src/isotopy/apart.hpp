// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Whether triangles stay apart while their corners move a little.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "ball.hpp"

namespace certificate {

/// A point or vector known up to an error on each axis.
using BallPoint = std::array<Ball, 3>;

/// Is there a direction with a positive product with all of these vectors, wherever they are within
/// their errors? True only if one is found and proved. Doubles only: the candidates are those of a
/// perceptron's first steps, and then the directions normal to the vertices, edges and triangles of
/// the hull of the unit vectors, among which is that of the largest least product. Where errors are
/// too large for it, the vectors that it fails for are added to the hull, a few times.
bool have_common_side(std::span<const BallPoint> vectors);

/// Has a triangle an area, wherever its corners are within their errors?
bool has_area(const BallPoint& a, const BallPoint& b, const BallPoint& c);

/// Do two triangles meet only in the vertices and the edge that they share, wherever the corners
/// are within their errors? True only if that is proved.
bool are_apart(std::span<const BallPoint> points, const std::array<std::uint32_t, 3>& first,
               const std::array<std::uint32_t, 3>& second);

}  // namespace certificate
