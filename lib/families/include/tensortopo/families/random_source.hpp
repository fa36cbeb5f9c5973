// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Seeded random numbers that are the same on every platform.
///
/// The standard fixes the engine but not the distributions, nor the last digits of log and cos. So
/// numbers are made of the engine's bits by exact additions only.
class RandomSource {
 public:
  /// The same numbers for the same seed on every platform.
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();
  /// Of mean 0 and variance 1, nearly normal: the sum of twelve uniform numbers less 6, a multiple
  /// of 2^-40.
  double normal();
  /// Uniform integer in [low, high].
  int integer(int low, int high);
  /// Six independent components, each from `normal`.
  SymmetricTensor<double> tensor();
  /// Entries in [-3, 3], not all zero.
  std::array<int, 4> quaternion();

 private:
  std::mt19937_64 engine_;
};

/// |q|^4 R T R^t for the rotation R of an integer quaternion q: exact while the numbers fit in 53
/// bits, and of the same mode.
SymmetricTensor<double> turned(const SymmetricTensor<double>& t, const std::array<int, 4>& q);

}  // namespace tensortopo
