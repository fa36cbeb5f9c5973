// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "level.hpp"
#include "files.hpp"

namespace certificate {

/// The tensors at the vertices of the mesh: three times the deviator, which has no fractions.
class Field : public ExactTensors {
 public:
  explicit Field(const Input& input);

  /// An integer multiple, by 2^-exponent(v), of three times the deviator at a vertex.
  Tensor<mpz_class> exact(std::uint32_t vertex) const override;
  /// Is the deviator zero, so that there is no mode?
  bool is_zero(std::uint32_t vertex) const;
  long exponent(std::uint32_t vertex) const { return exponents_[vertex]; }
  /// The corner's ball is three times the deviator by 2^-scale(v).
  long scale(std::uint32_t vertex) const { return exponents_[vertex] + shifts_[vertex]; }
  Corner corner(std::uint32_t vertex, bool above) const {
    return {&balls_[vertex], shifts_[vertex], this, vertex, above};
  }

 private:
  const Input& input_;
  std::vector<long> exponents_, shifts_;
  std::vector<Tensor<Ball>> balls_;
};

/// The enclosure of m / 2^shift, of entries up to one.
Tensor<Ball> enclosure(const Tensor<mpz_class>& m, long& shift);

}  // namespace certificate
