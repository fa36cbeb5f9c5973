// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/extract/level.hpp"

namespace tensortopo {

/// How many cells the refinement of a simplex of the mesh may take: the usual number settles nearly
/// everything, and where the level is next to a critical value none would. Great effort is for
/// thin tubes, next to modes 1 and -1, whose cells are across them as small as they are thin.
enum class Effort { usual, great };

inline std::size_t face_budget(Effort effort) { return effort == Effort::usual ? 5000 : 1000000; }

/// Levels so thin that the greater number has been of no use get the usual one.
template <class Scalar>
std::size_t tet_budget(Effort effort, const Level<Scalar>& level) {
  constexpr double kThinnest = 2e-7;
  const bool in_reach = static_cast<double>(Scalar(1) - level.mu_squared) > kThinnest;
  return effort == Effort::usual || !in_reach ? 50000 : 500000;
}

}  // namespace tensortopo
