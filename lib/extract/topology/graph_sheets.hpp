// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "extract/topology/cell_topology.hpp"

namespace tensortopo {

/// The sheets of a level that is a graph across a direction, from its boundary loops.
///
/// Seen along the direction's lines the sheets are regions of the plane. A loop is the outer
/// boundary of one, or goes around a hole. If all are outer boundaries all sheets are discs; if one
/// is, there is one sheet.
/// - A loop that meets the tetrahedron's silhouette is an outer boundary: around a hole there is
///   a region on all sides.
/// - Another stays on the side on which lines enter, or on that on which they leave. Lines that
///   enter below the level and leave above it meet it. So what lies just outside the loop is in the
///   region if it is below the level where they enter, or above it where they leave; and then the
///   loop goes around a hole.
///
/// @param loops     all of them
/// @param direction of a `SimplexProof` of the tetrahedron
/// @return nothing if that does not settle it
template <class Scalar>
std::optional<Sheets> sheets_of_graph(const TetWithCurves<Scalar>& tet, const BoundaryLoops& loops,
                                      const std::array<Scalar, 4>& direction);

}  // namespace tensortopo
