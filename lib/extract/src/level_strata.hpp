// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Why no proof could close on a tetrahedron: a deviator that vanishes inside, the level constant
/// in it, on a face or on an edge of it, or its value that of the one saddle inside, each decided
/// in rationals; `budget_exhausted` if none of these. Asked only where a proof has failed.
/// @param tensors  at those vertices, two to four, that have a deviator
UnresolvedReason level_stratum(std::span<const SymmetricTensor<double>> tensors,
                               const ModeValue& mode);

}  // namespace tensortopo
