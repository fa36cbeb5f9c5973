// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/topology/boundary/cell_boundary.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"

namespace tensortopo {

struct NearDegenerateSheets {
  Sheets sheets;
  std::vector<DegenerateArc> tubes;  ///< as in `CellTopology`
};

namespace detail {

/// The sheets of a level with nothing but the degenerate curve beyond it: tubes. They do not touch
/// edges: each ends in two closed curves on faces, around the two ends of its arc.
template <class Scalar>
std::optional<NearDegenerateSheets> tubes(const TetWithCurves<Scalar>& tet,
                                          const Level<Scalar>& level, const BoundaryLoops& loops);

}  // namespace detail

}  // namespace tensortopo
