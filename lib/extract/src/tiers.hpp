// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/extract/refinement.hpp"
#include "tensortopo/extract/simple_simplex.hpp"

namespace tensortopo {

/// The proofs of `simple_simplex.hpp` for a part of a simplex of the mesh, in tiers: first in the
/// extractor's own scalar and, where rounding hides the answer, again in a longer one from the
/// input's own bits.
///
/// @param root    the simplex of the mesh
/// @param weights homogeneous coordinates, in `root`, of the vertices of the part; exact
/// @param tensors the field there
template <class Scalar, std::size_t Vertices, std::size_t Part>
SimplexProof<Scalar, Part> prove_part(const LevelSimplex<Scalar, Vertices>& root,
                                      const std::array<std::array<double, Vertices>, Part>& weights,
                                      const std::array<Deviator<Scalar>, Part>& tensors,
                                      const Level<Scalar>& level);

/// The same for an edge: whether it is proved to hold at most one point of the level.
template <class Scalar, std::size_t Vertices>
bool edge_is_simple(const LevelSimplex<Scalar, Vertices>& root,
                    const std::array<std::array<double, Vertices>, 2>& weights,
                    const std::array<Deviator<Scalar>, 2>& tensors, const Level<Scalar>& level);

/// The side of the level on which the field is at a place in a simplex of the mesh, in the longer
/// scalar; unknown if that cannot tell either. Next to modes 1 and -1, where a double cannot tell
/// most modes from the level's, this spares rationals.
template <class Scalar, std::size_t Vertices>
Verdict side_in_longer_scalar(const LevelSimplex<Scalar, Vertices>& root,
                              const std::array<double, Vertices>& weights,
                              const Level<Scalar>& level);

}  // namespace tensortopo
