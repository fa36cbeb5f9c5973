// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/scalar/scalar_traits.hpp"

namespace tensortopo {

/// The real zeros (x : y) of c[0] x^3 + c[1] x^2 y + c[2] x y^2 + c[3] y^3, as unit pairs.
///
/// One to three of them; none if all coefficients are zero. Zeros at infinity of either chart are
/// found like any other. Simple zeros are accurate to a few ulp of their condition; a pair that is
/// equal to within rounding is given twice or not at all, never once.
template <RealScalar Scalar>
std::vector<std::array<Scalar, 2>> binary_cubic_zeros(const std::array<Scalar, 4>& coefficients);

}  // namespace tensortopo
