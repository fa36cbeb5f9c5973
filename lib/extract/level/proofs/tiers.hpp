// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "extract/level/exact_place.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "tensortopo/extract/level_simplex.hpp"

namespace tensortopo {

/// The proofs of `simple_simplex.hpp` for a part of a simplex of the mesh, in tiers: first in the
/// extractor's own scalar and, where rounding is inconclusive, again in a longer one from the
/// input's own bits.
///
/// @param root    the simplex of the mesh
/// @param places  homogeneous coordinates, in `root`, of the vertices of the part
/// @param tensors the field there
/// @param total   of `rounding_unit`, for the tensor with the largest error
template <class Scalar, std::size_t Vertices, std::size_t Part>
SimplexProof<Scalar, Part> prove_part(const LevelSimplex<Scalar, Vertices>& root,
                                      const std::array<ExactPlace<Vertices>, Part>& places,
                                      const std::array<Deviator<Scalar>, Part>& tensors,
                                      const Level<Scalar>& level, double total);

/// The same for an edge: whether it is proved to hold at most one point of the level.
template <class Scalar, std::size_t Vertices>
bool edge_is_simple(const LevelSimplex<Scalar, Vertices>& root,
                    const std::array<ExactPlace<Vertices>, 2>& places,
                    const std::array<Deviator<Scalar>, 2>& tensors, const Level<Scalar>& level,
                    double total);
template <class Scalar, std::size_t Vertices>
bool edge_is_simple(const LevelSimplex<Scalar, Vertices>& root,
                    const std::array<std::array<double, Vertices>, 2>& weights,
                    const std::array<Deviator<Scalar>, 2>& tensors, const Level<Scalar>& level) {
  const auto sum = [](const auto& w) { return std::accumulate(w.begin(), w.end(), 0.0); };
  return edge_is_simple<Scalar, Vertices>(root, {weights[0], weights[1]}, tensors, level,
                                          std::max(sum(weights[0]), sum(weights[1])));
}

/// The side of the level on which the field is at a place in a simplex of the mesh, in the longer
/// scalar; unknown if that cannot tell either. Next to modes 1 and -1, where a double cannot tell
/// most modes from the level's, this spares rationals.
template <class Scalar, std::size_t Vertices>
Verdict side_in_multiprecision(const LevelSimplex<Scalar, Vertices>& root,
                               const ExactPlace<Vertices>& place, const Level<Scalar>& level);

/// What the multiprecision scalar adds to `total` of `rounding_unit`, for each unit of the weights'
/// sum: it has more than 110 bits more.
inline constexpr double kMultiprecisionTotal = 0x1p-110;

/// The field of a simplex of the mesh at a place, rounded once; but for what `kMultiprecisionTotal`
/// says.
template <class Scalar, std::size_t Vertices>
Deviator<Scalar> tensor_in_multiprecision(const LevelSimplex<Scalar, Vertices>& root,
                                          const ExactPlace<Vertices>& place);

}  // namespace tensortopo
