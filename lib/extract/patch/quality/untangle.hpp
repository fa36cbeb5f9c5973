// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "extract/patch/patch_defects.hpp"

namespace tensortopo {

/// Mends triangles with defects one by one: by the other diagonal of an edge, another place of an
/// inner vertex on the level, an inner vertex taken out, or one more amid an edge. Each change
/// leaves fewer defects around it, and none that were not there.
///
/// Laws  (1) the complex stays homeomorphic, with the same boundary loops; (2) no edge beside these
///       joins two of their vertices on one face that it did not join before.
/// @param placed   the patch with the places of its vertices
/// @param defects  of it
/// @param boundaries  the boundary loops
/// @return whether something changed
template <class Scalar>
bool untangle(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
              std::span<const std::vector<BoundaryVertex>> boundaries, PlacedPatch placed,
              const PatchDefects& defects, Patch<Scalar>& patch);

}  // namespace tensortopo
