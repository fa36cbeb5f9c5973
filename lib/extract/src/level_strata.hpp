// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Why no proof could close on a tetrahedron: the level constant in it, on a face or on an edge of
/// it, or its value that of the one saddle inside, each decided in rationals; `budget_exhausted` if
/// none of these. Asked only where a proof has failed. Requires nonzero deviators.
UnresolvedReason level_stratum(const std::array<SymmetricTensor<double>, 4>& tensors,
                               const ModeValue& mode);

}  // namespace tensortopo
