// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Whether surfaces of the level are thin tubes around degenerate curves: cells of a refinement
/// must be as small as a tube is thin, and other proofs pay.
template <class Scalar>
bool is_thin(const Level<Scalar>& level);

struct ThinSheets {
  std::vector<SheetTopology> sheets;
  std::vector<DegenerateArc> tubes;  ///< as in `TetPlan`
};

/// The sheets that boundary loops of a thin level bound, without a refinement at that level.
///
/// 1. If nothing but the degenerate curve lies beyond the level, every sheet is a tube around one
///    arc of that curve, whose ends are known.
/// 2. Otherwise the sheets are proved at a thicker level, with no critical value in between.
///
/// @param loops the boundary loops at this level
/// @return nothing if neither applies
template <class Scalar>
std::optional<ThinSheets> sheets_of_thin_level(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const std::vector<std::vector<RimPiece>>& loops,
                                               Effort effort);

namespace detail {

/// The first way, for a level with nothing but the degenerate curve beyond it. Tubes do not touch
/// edges: each ends in two closed curves on faces, around the two ends of its arc.
template <class Scalar>
std::optional<ThinSheets> tubes(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                const std::vector<std::vector<RimPiece>>& loops);

/// By the Euler characteristic of all sheets together, which the critical points of the mode on one
/// side of the level give: enough to tell discs, a sheet with all loops if there is one, and an
/// annulus.
template <class Scalar>
std::optional<std::vector<SheetTopology>> counted_sheets(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const std::vector<std::vector<RimPiece>>& loops);

/// The same with more effort. Where critical points next to the ends of the mode are not certain,
/// or a curve follows an edge, what is on the side without the level's curve is counted from a
/// level far away, at which a refinement is short; and loops are joined beyond the level by whole
/// arcs of the degenerate curve and by walks along it.
template <class Scalar>
std::optional<std::vector<SheetTopology>> sheets_counted_with_effort(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const std::vector<std::vector<RimPiece>>& loops);

/// The sheets, known from another level of the same sign from which there is no critical value to
/// this one. Isotopies keep edges and faces: crossings of an edge correspond in their order, arcs
/// by their ends, and a closed curve to the one that bounds the same part of its face.
template <class Scalar>
std::optional<std::vector<SheetTopology>> sheets_of_isotopic_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const std::vector<std::vector<RimPiece>>& loops, const Level<Scalar>& other,
    Effort effort);

/// The second way.
///
/// @param open_until there is no critical gap from the level's own to this one
template <class Scalar>
std::optional<std::vector<SheetTopology>> sheets_of_thicker_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const std::vector<std::vector<RimPiece>>& loops, double open_until, Effort effort);

/// The gap 1 - mode^2 up to which it is of use to be free of critical values.
double widest_gap();

}  // namespace detail
}  // namespace tensortopo
