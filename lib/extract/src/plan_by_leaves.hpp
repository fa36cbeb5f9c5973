// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// `plan_tet` at this very level: from one monotone tetrahedron or from a refinement.
template <class Scalar>
std::optional<TetPlan<Scalar>> plan_by_leaves(const TetWithCurves<Scalar>& tet,
                                              const Level<Scalar>& level, Effort effort);

/// `plan_tet`, of a tetrahedron whose proof as a whole has been made (or not: null).
template <class Scalar>
std::optional<TetPlan<Scalar>> plan_tet_by(const SimplexProof<Scalar, 4>* known,
                                           const TetWithCurves<Scalar>& tet,
                                           const Level<Scalar>& level,
                                           const Level<Scalar>* isotopic = nullptr,
                                           Effort effort = Effort::usual);

}  // namespace tensortopo
