// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Whether mu is the mode of a saddle in the tetrahedron, decided in rationals. Requires four
/// tensors with nonzero deviators.
bool is_level_at_saddle(std::span<const SymmetricTensor<double>> tensors, const ModeValue& mode);

/// False for most levels and tetrahedra without such a saddle, at little cost.
/// Requires deviators scaled to P in [3, 12).
bool may_be_level_at_saddle(const std::array<Deviator<double>, 4>& tensors, double mu);

}  // namespace tensortopo
