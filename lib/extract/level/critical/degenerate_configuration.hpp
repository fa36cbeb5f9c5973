// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tensortopo/extract/unresolved_reason.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Why no proof could close on a tetrahedron: a deviator that vanishes inside, the level constant
/// in it, on a face or on an edge of it, or its value that of the one saddle inside or of a
/// critical point of an edge or of the plane of a face, each decided in rationals;
/// `budget_exhausted` if none of these. Asked only where a proof has failed.
/// @param tensors  at those vertices, two to four, that have a deviator
UnresolvedReason degenerate_configuration(std::span<const SymmetricTensor<double>> tensors,
                                          const ModeValue& mode);

/// Whether the mode is mu everywhere in the simplex of these tensors, none of them without
/// deviator.
bool is_level_constant(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode);

}  // namespace tensortopo
