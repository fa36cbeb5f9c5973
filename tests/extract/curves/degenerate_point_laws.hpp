// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tensortopo::test {

/// In faces of tetrahedra of independent normal tensors the surface has as many closed curves as
/// exact counting finds degenerate points.
///
/// Where the mode has no critical value in the plane of a face from the level to 1 (or -1), each
/// degenerate point is alone in a disc of modes in the superlevel set. If no side of the face is
/// crossed, such discs are inside or outside: other faces are left out.
/// @param mode next to 1 or -1, so that few are left out
/// @param count of tetrahedra
void expect_a_loop_around_each_degenerate_point(const std::string& mode, int count,
                                                std::uint64_t seed);

}  // namespace tensortopo::test
