// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "extract/patch/manifold/manifold_crossings.hpp"

namespace tensortopo {

/// Further samples of the curves so that the chords between samples do not cross in the chart, as
/// those of two curves close to each other may: where they do, steps are halved.
///
/// @param crossings the `boundary_crossings`, which are samples as well
template <class Scalar>
std::vector<SampleRequest<Scalar>> separating_samples(
    const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
    const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
    std::span<const SampleRequest<Scalar>> crossings, const Level<Scalar>& level);

}  // namespace tensortopo
