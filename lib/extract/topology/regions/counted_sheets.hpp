// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/topology/boundary/cell_boundary.hpp"
#include "tensortopo/field/cell_critical_points.hpp"

namespace tensortopo::detail {

/// By the Euler characteristic of all sheets together, which the critical points of the mode on one
/// side of the level give: enough to tell discs, a sheet with all loops if there is one, and an
/// annulus.
template <class Scalar>
std::optional<Sheets> counted_sheets(const TetWithCurves<Scalar>& tet,
                                     const CellCriticalPoints& points, const Level<Scalar>& level,
                                     const BoundaryLoops& loops);

/// The same with a larger budget. Where critical points next to the ends of the mode are not
/// certain, or a curve follows an edge, what is on the side without the level's curve is counted
/// from a level far away, at which a refinement is short; and loops are joined in the superlevel
/// set by whole arcs of the degenerate curve and by walks along it.
template <class Scalar>
std::optional<Sheets> sheets_counted_from_distant_level(const TetWithCurves<Scalar>& tet,
                                                        const Level<Scalar>& level,
                                                        const BoundaryLoops& loops);

}  // namespace tensortopo::detail
