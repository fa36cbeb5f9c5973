// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Signs of determinants of doubles: by bounds of rounding errors, and where these leave it open, in
// whole numbers.
#pragma once

#include <array>
#include <cstddef>

namespace certificate {

/// On which side of the plane through a, b and c is d? 1 if (b - a, c - a, d - a) is a right-handed
/// frame, -1 if left-handed, 0 if d is in the plane.
int side_of(const std::array<double, 3>& a, const std::array<double, 3>& b,
            const std::array<double, 3>& c, const std::array<double, 3>& d);

/// The turn from a to b to c, seen along an axis: 1 if counterclockwise in the plane of the axes
/// after it, -1 if clockwise, 0 if on one line.
int turn(const std::array<double, 3>& a, const std::array<double, 3>& b,
         const std::array<double, 3>& c, std::size_t axis);

}  // namespace certificate
