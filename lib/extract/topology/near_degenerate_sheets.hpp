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
///    one arc of that curve, whose ends are known (`detail::tubes`).
/// 2. Else critical points may count the sheets, and paths tell which loops belong to one
///    (`detail::counted_sheets`).
/// 3. Else the sheets are proved at an isotopic level, with no critical value in between
///    (`sheets_of_wider_isotopic_level`).
/// 4. Else those of a distant level and the critical points between it and this one may count them
///    (`detail::sheets_counted_from_distant_level`).
///
/// @param loops the boundary loops at this level
/// @return nothing if none applies
template <class Scalar>
std::optional<NearDegenerateSheets> sheets_of_near_degenerate_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, const BoundaryLoops& loops,
    Budget budget);

}  // namespace tensortopo
