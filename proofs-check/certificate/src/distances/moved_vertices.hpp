// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "distances/weighted_tensors.hpp"
#include "places.hpp"
#include "surface/compare_surface.hpp"

namespace certificate {

/// The length that a reach stands for: (4 + n mod 4) 2^floor(n / 4).
double reach_length(std::int64_t n);

/// The vertices of a level's triangles, moved both ways along the gradient of the mode, or whatever
/// the level is of.
///
/// A moved vertex is an exact point of its carrier, the one whose weights are in proportion to
/// some positive doubles. These are computed in doubles, and need not be more than near to what the
/// certificate means: all that follows from it is proved of these points.
class MovedVertices {
 public:
  enum Way : std::uint32_t { kBehind = 0, kAhead = 1 };

  /// @param reach  for each vertex
  MovedVertices(const LevelCase& c, const PlacedSurface& placed,
                const std::vector<std::int64_t>& reach);

  /// Weights at the corners of the carrier; not all positive if the vertex would leave it.
  const std::array<double, 4>& weights(std::size_t vertex, Way way) const {
    return points_[id_of(vertex, way)];
  }
  /// The weights of the field's exact tensors there. @pre stays(vertex)
  Place<4> place(std::size_t vertex, Way way) const { return tensors_.place(id_of(vertex, way)); }
  bool stays(std::size_t vertex) const;
  /// Its tensor, and the side on which it should be. @pre stays(vertex)
  Corner corner(std::size_t vertex, Way way) const {
    return tensors_.corner(id_of(vertex, way), way == kAhead);
  }
  /// Is it at most so far from the vertex of the surface, both ways?
  bool is_within(std::size_t vertex, double bound) const;

 private:
  static std::uint32_t id_of(std::size_t vertex, Way way) {
    return static_cast<std::uint32_t>(2 * vertex + way);
  }
  void move(std::size_t vertex, double reach);

  const LevelCase& c_;
  const PlacedSurface& placed_;
  std::vector<std::array<double, 4>> points_;  ///< weights
  WeightedTensors tensors_;                    ///< there
};

}  // namespace certificate
