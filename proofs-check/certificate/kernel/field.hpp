// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input.hpp"
#include "level.hpp"

namespace certificate {

/// The tensors at the vertices of the mesh: three times the deviator, which has no fractions, and
/// the trace and the number one if they are asked for.
class Field : public ExactTensors {
 public:
  Field(const Input& input, Multiples multiples, const ForAll& for_all);
  const Multiples& multiples() const { return multiples_; }

  /// An integer multiple, by 2^-exponent(v), of the tensor at a vertex.
  Tensor<mpz_class> exact(std::uint32_t vertex) const override;
  /// Is all of it zero, so that there is no mode, or no anisotropy?
  bool is_zero(std::uint32_t vertex) const { return is_zero_[vertex] != 0; }
  long exponent(std::uint32_t vertex) const { return exponents_[vertex]; }
  /// The corner's ball is the tensor by 2^-scale(v).
  long scale(std::uint32_t vertex) const { return exponents_[vertex] + shifts_[vertex]; }
  Corner corner(std::uint32_t vertex, bool above) const {
    return {&balls_[vertex], shifts_[vertex], this, vertex, above};
  }

 private:
  const Input& input_;
  Multiples multiples_;
  std::vector<long> exponents_, shifts_;
  std::vector<char> is_zero_;
  std::vector<Tensor<Ball>> balls_;
};

/// The enclosure of m / 2^shift, of entries up to one.
Tensor<Ball> enclosure(const Tensor<mpz_class>& m, long& shift);

}  // namespace certificate
