// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// The topology of a level whose triangles in each tetrahedron are proved to have it, read off
/// these and the carriers of their vertices. Crossings have barycentric coordinates as weights, and
/// `rising` is left to the caller.
///
/// Nothing is read of tetrahedra that are undecided. Those whose boundary loops do not run along
/// faces from crossing to crossing are left out, and appended to `undecided` as
/// `inconsistent_samples`.
LevelTopology topology_of(const TetMesh& mesh, const SurfaceMesh& surface,
                          std::vector<UndecidedCell>& undecided);

}  // namespace tensortopo
