// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// The power of two that brings the largest component of four tensors into [1/2, 1): squares then
/// neither overflow nor, where they matter, underflow.
struct CellScale {
  int exponent = 0;

  explicit CellScale(const std::array<const SymmetricTensor<double>*, 4>& tensors) {
    double largest = 0;
    for (const auto* t : tensors)
      for (const double x : {t->xx, t->yy, t->zz, t->xy, t->yz, t->xz})
        largest = std::max(largest, std::abs(x));
    if (!(largest > 0)) return;
    std::frexp(largest, &exponent);
    exponent = -exponent;
  }

  SymmetricTensor<double> operator()(const SymmetricTensor<double>& t) const {
    const auto scaled = [&](double x) { return std::ldexp(x, exponent); };
    return {scaled(t.xx), scaled(t.yy), scaled(t.zz), scaled(t.xy), scaled(t.yz), scaled(t.xz)};
  }
};

}  // namespace tensortopo
