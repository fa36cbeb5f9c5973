// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "tensortopo/extract/refinement.hpp"

namespace tensortopo::detail {

/// Corner i of a simplex of the mesh.
template <class Scalar, std::size_t Vertices>
RefinementVertex<Scalar, Vertices> corner_vertex(const LevelSimplex<Scalar, Vertices>& simplex,
                                                 std::size_t i);

/// The place a u + b v, and a and b as scaled for it.
template <class Scalar, std::size_t Vertices>
struct PlaceBetween {
  RefinementVertex<Scalar, Vertices> vertex;
  double a, b;
};

/// Nothing if its coordinates have too many bits (more than doubles have where the field is not
/// small: cells so small prove nothing there), or if the deviator vanishes there: no part with such
/// a corner is ever proved.
template <class Scalar, std::size_t Vertices>
std::optional<PlaceBetween<Scalar, Vertices>> place_between(
    const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
    const std::array<std::int64_t, 2>& shares, const RefinementVertex<Scalar, Vertices>& u,
    const RefinementVertex<Scalar, Vertices>& v);

/// How much of each end the place has at which an edge is cut: as given, or where the ends' tensors
/// are nearly opposite so much that the field is about as small there as it is on the edge.
///
/// All that happens on such an edge happens there. Halving would come close to it as well, but in
/// as many cuts as the closeness has bits, and for each edge of each cell anew: in a bent beam's
/// neutral layer, where the stress is of rank one but for a small rest, in their third power.
///
/// @param usual  whole numbers below 2^53, not negative; which of them is larger is kept
template <class Scalar, std::size_t Vertices>
std::array<std::int64_t, 2> shares_of_cut(const RefinementVertex<Scalar, Vertices>& u,
                                          const RefinementVertex<Scalar, Vertices>& v,
                                          const std::array<std::int64_t, 2>& usual);

/// The same for an edge whose ends are not nearly opposite, if the field nearly vanishes inside the
/// triangle with w: the place opposite to w, so that the cut after the next goes where it does. The
/// axis of a twisted shaft is like that.
template <class Scalar, std::size_t Vertices>
std::optional<std::array<std::int64_t, 2>> shares_opposite_to(
    const RefinementVertex<Scalar, Vertices>& w, const RefinementVertex<Scalar, Vertices>& u,
    const RefinementVertex<Scalar, Vertices>& v);

}  // namespace tensortopo::detail
