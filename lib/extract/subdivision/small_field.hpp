// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "extract/subdivision/refinement_vertex.hpp"

namespace tensortopo::detail {

/// How much of each end the place has at which an edge is cut: as given, or where the ends' tensors
/// are nearly opposite so much that the field is about as small there as it is on the edge.
///
/// All that happens on such an edge happens there. Halving would come close to it as well, but in
/// as many cuts as the closeness has bits, and for each edge of each cell anew: in a bent beam's
/// neutral layer, where the stress is of rank one but for a small rest, in their third power.
///
/// @param usual  whole numbers below 2^53, not negative; which of them is larger is kept
template <class Scalar, std::size_t Vertices>
Shares<2> shares_of_cut(const RefinementVertex<Scalar, Vertices>& u,
                        const RefinementVertex<Scalar, Vertices>& v, const Shares<2>& usual);

/// Where the field is smallest in a triangle or a tetrahedron, if it nearly vanishes there and
/// that is well inside: on the axis of a twisted shaft, next to the tip of a cone. With a vertex
/// there its parts have nothing of the kind, as only the ratios of a place's coordinates count.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<Shares<Corners>> shares_of_small_field(
    const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>& corners);

}  // namespace tensortopo::detail
