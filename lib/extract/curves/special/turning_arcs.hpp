// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "extract/curves/points/exact_direction.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// Directions in a plane in their order around it, each turned so that they follow each other
/// within half a turn, counter-clockwise as seen from the tip of the plane's normal.
struct TurnOrder {
  std::vector<std::size_t> order;      ///< positions in the list given
  std::vector<ExactDirection> turned;  ///< in this order
};

/// Nothing if 150 digits do not separate two.
std::optional<TurnOrder> order_in_plane(const ExactDirection& normal,
                                        std::span<const ExactDirection> directions);

/// An arc between neighbours; both are the same if there is one only.
struct TurningArc {
  std::size_t begin = 0, end = 0;  ///< positions in the list given
  Vector3<Extended> first{};       ///< unit
  double turn = 0;                 ///< by which the direction turns about the normal
};

/// Whether a place is inside, which all places of an arc are or none.
using InsideTest = std::function<Verdict(const ExactDirection&)>;

/// The arcs between directions in a plane that are inside; nothing if that is not certain.
std::optional<std::vector<TurningArc>> arcs_inside(const ExactDirection& normal,
                                                   std::span<const ExactDirection> directions,
                                                   const InsideTest& inside);

/// Directions of an arc at most `largest_turn` apart, ends left out.
std::vector<Vector3<Extended>> directions_along(const ExactDirection& normal, const TurningArc& arc,
                                                double largest_turn);

}  // namespace tensortopo
