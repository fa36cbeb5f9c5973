// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>

#include "extract/level/exact_place.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/extract/level_simplex.hpp"

namespace tensortopo {

/// Side of the level for the field of a simplex at exact homogeneous weights; all tiers.
///
/// @param total  of `rounding_unit`, for the tensor; the weights' sum if it was computed from them
template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::type_identity_t<ExactPlace<Vertices>>& place, const Level<Scalar>& level,
              double total);
template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::array<double, Vertices>& weights, const Level<Scalar>& level) {
  return is_above(simplex, tensor, weights, level,
                  std::accumulate(weights.begin(), weights.end(), 0.0));
}

}  // namespace tensortopo
