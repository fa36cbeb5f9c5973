// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Why no proof could close on a tetrahedron: a deviator that vanishes inside, the level constant
/// in it, on a face or on an edge of it, or its value that of the one saddle inside or of a
/// critical point of an edge or of the plane of a face, each decided in rationals;
/// `budget_exhausted` if none of these. Asked only where a proof has failed.
/// @param tensors  at those vertices, two to four, that have a deviator
UnresolvedReason level_stratum(std::span<const SymmetricTensor<double>> tensors,
                               const ModeValue& mode);

/// Whether the mode is mu everywhere in the simplex of these tensors, none of them without
/// deviator.
bool is_level_constant(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode);

/// Whether mu is the mode of a saddle in the tetrahedron, decided in rationals. Requires four
/// tensors with nonzero deviators.
bool is_level_at_saddle(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode);

/// False for most levels and tetrahedra without such a saddle, at little cost.
/// Requires deviators scaled to P in [3, 12).
bool may_be_level_at_saddle(const std::array<Deviator<double>, 4>& tensors, double mu);

}  // namespace tensortopo
