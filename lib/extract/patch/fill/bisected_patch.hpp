// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/patch/patch.hpp"
#include "tensortopo/extract/extract_options.hpp"

namespace tensortopo {

/// A disc by bisection of edges. Its boundary loop is filled (`cut_polygon`) by diagonals along
/// which the medium eigenvectors turn little. Then edges inside are bisected, longest first, by a
/// vertex on the level, until along each either the eigenvectors turn no further than from one
/// sample to the next (the dominant one twice as far), or the level is no farther from its middle
/// than an arc that turns so far is from its chord; next to the degenerate curve also until chords
/// sag by no more than `detail::kLargestSag`. It ends earlier after twelve rounds, and leaves an
/// edge beside which no vertex is found.
///
/// Law  As a complex a disc with that boundary loop; no edge inside joins two vertices on one face.
/// @return false if the loop cannot be filled so, or too many vertices would be needed
template <class Scalar>
bool mesh_bisected_disc(const TetWithCurves<Scalar>& tet, std::span<const BoundaryVertex> boundary,
                        const Level<Scalar>& level, const Sampling& sampling, Patch<Scalar>& out);

/// The same for a tube: the triangles between its two boundary loops (`join_loops`) are bisected.
/// @return also false if the dominant eigenvectors turn by more than 60 degrees from their mean, or
///         the medium ones do not turn around both loops once, or a face holds vertices of both
///         that would be joined
template <class Scalar>
bool mesh_bisected_tube(const TetWithCurves<Scalar>& tet, std::span<const BoundaryVertex> first,
                        std::span<const BoundaryVertex> last, const Level<Scalar>& level,
                        const Sampling& sampling, Patch<Scalar>& out);

}  // namespace tensortopo
