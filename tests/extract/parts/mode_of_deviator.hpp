// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::test {

inline Real50 mode_of_deviator(const Deviator<Real50>& d) {
  const Real50 p = norm_form(d);
  return sqrt(Real50(2)) * determinant_form(d) / (p * sqrt(p));
}

}  // namespace tensortopo::test
