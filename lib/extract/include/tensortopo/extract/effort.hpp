// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/extract/level.hpp"

namespace tensortopo {

/// How many cells the refinement of a simplex of the mesh may take: a little settles nearly
/// everything, and where the level is next to a critical value no number would, so that is looked
/// at before the usual one is spent. Great effort is for thin tubes, next to modes 1 and -1, whose
/// cells are across them as small as they are thin.
enum class Effort { little, usual, great };

/// A tube along the whole of a face takes some 100 (1 - mode^2)^(-1/4) cells: at the modes next to
/// 1 and -1, whose signs take 50 digits, this is given up.
template <class Scalar>
std::size_t face_budget(Effort effort, const Level<Scalar>& level) {
  constexpr double kThinnest = 1e-15;
  const bool in_reach = static_cast<double>(Scalar(1) - level.mu_squared) > kThinnest;
  return effort != Effort::great ? 5000 : in_reach ? 1000000 : 10000;
}

/// Levels so thin that the greater number has been of no use get the usual one, and those at which
/// that is of none, a tenth. Cells along a tube grow in number like (1 - mode^2)^(-1/4): with the
/// least factor seen, 29, they are more than 50,000 from 1 - mode^2 = 1e-13 on.
template <class Scalar>
std::size_t tet_budget(Effort effort, const Level<Scalar>& level) {
  constexpr double kThinnest = 2e-7, kThinnestOfUsual = 1e-13;
  const auto gap = static_cast<double>(Scalar(1) - level.mu_squared);
  if (!(gap > kThinnestOfUsual)) return 5000;
  if (effort == Effort::little) return 10000;
  return effort == Effort::usual || !(gap > kThinnest) ? 50000 : 500000;
}

/// Whether the refinement of a tetrahedron is no other with great effort than with the usual one.
template <class Scalar>
bool is_effort_spent(Effort effort, const Level<Scalar>& level) {
  return effort == Effort::great && tet_budget(effort, level) == tet_budget(Effort::usual, level);
}

}  // namespace tensortopo
