// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "level.hpp"

namespace certificate {

/// A tensor that need not be made.
struct GivenTensor : ExactTensors {
  const Tensor<mpz_class>& tensor;

  explicit GivenTensor(const Tensor<mpz_class>& t) : tensor(t) {}
  Tensor<mpz_class> exact(std::uint32_t) const override { return tensor; }
};

/// Is a tensor above the level?
/// @param ball  encloses it
inline bool is_above(const Level& level, const Tensor<Ball>& ball,
                     const Tensor<mpz_class>& exact) {
  const GivenTensor source(exact);
  return level.above({&ball, 0, &source, 0});
}

}  // namespace certificate
