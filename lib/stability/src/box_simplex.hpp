// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "traceless.hpp"

namespace tensortopo::stability {

/// The linear fields on a simplex whose vertex deviators are anywhere in a ball each: the members.
template <std::size_t Vertices>
struct BoxSimplex {
  std::array<Traceless, Vertices>
      tensors;                         ///< the balls' centres, of norm from 1 to `kLargestNorm`
  std::array<double, Vertices> radii;  ///< below the norms
};

/// A point, by homogeneous coordinates >= 0.
template <std::size_t Vertices>
using Place = std::array<double, Vertices>;

/// Some points of a simplex, and the field there: it is the corners of a part.
template <std::size_t Vertices, std::size_t Corners>
struct Part {
  std::array<Place<Vertices>, Corners> places;
  std::array<Traceless, Corners> tensors;
  std::array<double, Corners> norms, radii;
  std::array<double, Corners> bounds;  ///< of the norm, and of what its computation adds up
};

template <std::size_t Vertices, std::size_t Corners>
Part<Vertices, Corners> part_of(const BoxSimplex<Vertices>& simplex,
                                const std::array<Place<Vertices>, Corners>& places) {
  Part<Vertices, Corners> part;
  part.places = places;
  for (std::size_t a = 0; a < Corners; ++a) {
    part.tensors[a] = {};
    part.radii[a] = part.bounds[a] = 0;
    for (std::size_t i = 0; i < Vertices; ++i) {
      part.tensors[a] = part.tensors[a] + places[a][i] * simplex.tensors[i];
      part.radii[a] += places[a][i] * simplex.radii[i];
      part.bounds[a] += kLargestNorm * places[a][i];
    }
    part.norms[a] = norm(part.tensors[a]);
  }
  return part;
}

/// The mean of the corners, as a part of one point.
template <std::size_t Vertices, std::size_t Corners>
Part<Vertices, 1> centre_of(const BoxSimplex<Vertices>& simplex,
                            const Part<Vertices, Corners>& part) {
  Place<Vertices> centre{};
  for (const auto& place : part.places)
    for (std::size_t i = 0; i < Vertices; ++i) centre[i] += place[i] / static_cast<double>(Corners);
  return part_of<Vertices, 1>(simplex, {centre});
}

}  // namespace tensortopo::stability
