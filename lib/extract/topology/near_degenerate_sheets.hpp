// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/run/budget.hpp"
#include "extract/topology/boundary/cell_boundary.hpp"
#include "extract/topology/regions/tubes.hpp"

namespace tensortopo {

/// The sheets that boundary loops of a near-degenerate level bound, without a refinement at that
/// level.
///
/// 1. If nothing but the degenerate curve lies in the superlevel set, every sheet is a tube around
/// one
///    arc of that curve, whose ends are known.
/// 2. Otherwise the sheets are proved at a isotopic level, with no critical value in between.
///
/// @param loops the boundary loops at this level
/// @return nothing if neither applies
template <class Scalar>
std::optional<NearDegenerateSheets> sheets_of_near_degenerate_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, const BoundaryLoops& loops,
    Budget budget);

}  // namespace tensortopo
