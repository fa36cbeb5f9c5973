// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Sign of mode - mu for the field of a simplex at barycentric coordinates, in exact rational
/// arithmetic: the last tier, asked only where rounding could have decided.
///
/// @param tensors   the vertex tensors as given
/// @param exponents the tensor of vertex i enters as `tensors[i] * 2^exponents[i]`
/// @param weights   barycentric coordinates, exact as they stand
/// @return zero also where the deviator vanishes, since the mode is undefined there
Sign exact_side_of_level(std::span<const SymmetricTensor<double>> tensors,
                         std::span<const int> exponents, std::span<const double> weights,
                         const ModeValue& mode);

}  // namespace tensortopo
