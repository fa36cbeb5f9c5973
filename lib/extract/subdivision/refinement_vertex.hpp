// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "extract/subdivision/refinement.hpp"

namespace tensortopo::detail {

/// Corner i of a simplex of the mesh.
template <class Scalar, std::size_t Vertices>
RefinementVertex<Scalar, Vertices> corner_vertex(const LevelSimplex<Scalar, Vertices>& simplex,
                                                 std::size_t i);

/// A place inside an edge, triangle or tetrahedron, and how much of each of its corners that is.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
struct PlaceAmong {
  RefinementVertex<Scalar, Vertices> vertex;
  std::array<double, Corners> parts;  ///< the vertex is the sum of the corners times these
};

/// How much of each corner a place has, up to a common factor: whole numbers, not negative.
template <std::size_t Corners>
using Shares = std::array<std::int64_t, Corners>;

/// Nothing if its coordinates have too many bits (more than doubles have where the field is not
/// small: cells so small prove nothing there), or if the deviator vanishes there: no part with such
/// a corner is ever proved.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<PlaceAmong<Scalar, Vertices, Corners>> place_among(
    const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
    const Shares<Corners>& shares,
    const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>& corners);

}  // namespace tensortopo::detail
