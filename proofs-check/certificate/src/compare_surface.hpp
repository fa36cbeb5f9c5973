// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare_level.hpp"

namespace certificate {

/// The triangles of a level: are they a surface, oriented, whose part in each tetrahedron has the
/// claimed sheets with their loops, glued across faces along the same curves, and are its
/// components as claimed? One claim for each component, and one for all of the pieces.
///
/// @param left_out tetrahedra about which nothing is claimed
void compare_surface(const LevelCase& c, const CrossingVertices& vertices,
                     const std::vector<bool>& left_out, Ledger& ledger);

}  // namespace certificate
