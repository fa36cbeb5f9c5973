// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/run/budget.hpp"
#include "extract/topology/boundary/cell_boundary.hpp"

namespace tensortopo::detail {

/// The sheets, known from another level of the same sign from which there is no critical value to
/// this one. Isotopies keep edges and faces: crossings of an edge correspond in their order, arcs
/// by their ends, and a closed curve to the one that bounds the same part of its face.
template <class Scalar>
std::optional<Sheets> sheets_of_isotopic_level(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const BoundaryLoops& loops,
                                               const Level<Scalar>& other, Budget budget);

/// The same at a level farther from modes 1 and -1 that is found here: see
/// `sheets_of_near_degenerate_level`.
///
/// @param open_until there is no critical gap from the level's own to this one
template <class Scalar>
std::optional<Sheets> sheets_of_wider_isotopic_level(const TetWithCurves<Scalar>& tet,
                                                     const Level<Scalar>& level,
                                                     const BoundaryLoops& loops, double open_until,
                                                     Budget budget);

}  // namespace tensortopo::detail
