// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

inline SymmetricTensor<Rational> in_rationals(const SymmetricTensor<double>& t) {
  return {Rational(t.xx), Rational(t.yy), Rational(t.zz),
          Rational(t.xy), Rational(t.yz), Rational(t.xz)};
}

}  // namespace tensortopo
