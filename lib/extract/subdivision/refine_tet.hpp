// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/run/budget.hpp"
#include "extract/subdivision/refinement.hpp"

namespace tensortopo::detail {

/// Refines a tetrahedron until every cell is simple: by angles, which settles nearly everything;
/// along lines of saddles where it has such, as cells by angles would have to be as small along
/// them as they are across. False if this budget is not enough. With a small budget also where all
/// that is left is around a single point, or where cells along a line of saddles have not been
/// enough: the level may be next to a critical value.
template <class Scalar>
bool refine_tet(Refinement<Scalar, 4>& refinement, const LevelSimplex<Scalar, 4>& simplex,
                const Level<Scalar>& level, Budget budget);

}  // namespace tensortopo::detail
