// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/compare_surface.hpp"

namespace certificate {

/// Vectors at the vertices of a level, by their arrays' names: normals, and of the mode medium and
/// dominant eigenvectors. Counts at how many vertices each is shown to be what its name says, up to
/// the accuracy that FORMAT.md states, and refutes one that is certainly not. Where neither is shown
/// it is as written.
void compare_vectors(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger);

}  // namespace certificate
