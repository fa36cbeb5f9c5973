// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Whether surfaces of the level are thin tubes around degenerate curves, so that it pays to look
/// for a thicker one of the same topology.
template <class Scalar>
bool is_thin(const Level<Scalar>& level);

/// The sheets that boundary loops of a thin level bound, found at a level that is thicker.
///
/// Cells of a refinement must be as small as a tube is thin. But between two levels without a
/// critical value in between (`uncritical_gap`), all is isotopic, on edges and faces as well: so
/// the sheets are proved where the tubes are thick, and named by the loops that correspond.
/// Crossings of an edge correspond in their order, arcs by their ends, and a closed curve to the
/// one that bounds the same part of its face.
///
/// @return nothing if no thicker level is free, no proof closes there either, or two closed curves
///         of a face bound one part of it
template <class Scalar>
std::optional<std::vector<SheetTopology>> sheets_of_thicker_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const std::vector<std::vector<RimPiece>>& loops);

}  // namespace tensortopo
