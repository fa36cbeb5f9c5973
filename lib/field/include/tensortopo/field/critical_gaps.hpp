// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensortopo/field/cell_critical_points.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Where the topology of a tetrahedron's levels can change, seen from one level.
///
/// A mode m is measured by its gap 1 - m^2; all modes here have one sign. Critical values are those
/// of the mode of the linear field inside the tetrahedron, along its faces and edges, and at its
/// vertices. By Thom's first isotopy lemma, levels without a critical value between them are
/// isotopic, within the tetrahedron and within each face and edge.
struct CriticalGaps {
  /// Proved: no critical value has a gap from that of the level up to, but not including, this.
  double open_until = 0;
  /// Proved: none is closer to +-1 than the level, other than +-1 itself inside or on a face. So
  /// the level surrounds the degenerate curve and nothing else.
  bool none_beyond = false;
};

/// The critical gaps around the level of a mode.
///
/// @param widest no gap beyond it is looked at, and `open_until` is at most that
/// @return nothing if the level cannot be told from a critical one, or the field is not of full rank
std::optional<CriticalGaps> critical_gaps(const CellCriticalPoints& points, const ModeValue& mode,
                                          double widest);

}  // namespace tensortopo
