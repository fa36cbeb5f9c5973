// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "extract/topology/cell_topology.hpp"

namespace tensortopo {

/// A point inside a tetrahedron brought onto the level by Newton steps along its gradient.
/// @param weights  of scaled tensors, positive, with the sum one
/// @return nothing if it leaves the tetrahedron, or there is no gradient
template <class Scalar>
std::optional<InnerVertex<Scalar>> vertex_on_level(const TetWithCurves<Scalar>& tet,
                                                   const Level<Scalar>& level,
                                                   const std::array<Scalar, 4>& weights);

/// The same from a point that may be far from the level.
/// @return nothing, as well, if the steps do not become small
template <class Scalar>
std::optional<InnerVertex<Scalar>> vertex_on_far_level(const TetWithCurves<Scalar>& tet,
                                                       const Level<Scalar>& level,
                                                       const std::array<Scalar, 4>& weights);

}  // namespace tensortopo
