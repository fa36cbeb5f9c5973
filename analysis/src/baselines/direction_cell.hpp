// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "baselines/neutral_map.hpp"

namespace tensortopo::baselines {

/// The coefficient of the cube of a corner.
inline constexpr std::array<std::size_t, 3> kCorner{cubic_place(0, 0), cubic_place(3, 0),
                                                    cubic_place(0, 3)};

/// A triangle of directions and the weights on it.
struct DirectionCell {
  std::array<Vector3<double>, 3> corners;
  std::array<Cubic, 4> weights;
  std::array<bool, 3> singular{};  ///< the corner is a singularity: all weights are 0
  int depth = 0;
};

/// Whether the tetrahedron may be met with all weights positive, or all negative.
std::pair<bool, bool> possible_signs(const DirectionCell& cell);

/// A tetrahedron, and how closely it is to be met.
struct CellTolerance {
  std::array<Vector3<double>, 4> places;
  std::array<double, 4> heights{};  ///< of the corners over their faces
  double distance = 0;
};

/// Whether the image of a cell, the weights being of this sign in the tetrahedron, is within the
/// distance of a plane, and the places where a weight vanishes as close to a line.
bool is_flat(const DirectionCell& cell, double sign, const CellTolerance& tolerance);

/// Cuts a cell across its longest side. The last corner of both halves is the middle of that side.
std::array<DirectionCell, 2> halves(DirectionCell cell);

}  // namespace tensortopo::baselines
