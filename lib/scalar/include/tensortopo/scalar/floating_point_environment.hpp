// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef __FAST_MATH__
#error \
    "tensortopo: -ffast-math removes the guarantees that this library is about; compile without it"
#endif

#include <cfenv>

namespace tensortopo {

/// Scope in which double arithmetic is IEEE 754 with rounding to nearest and subnormal numbers.
///
/// Merely linking a library that was built with -ffast-math switches the processor to flush
/// subnormal numbers to zero, and then (1e-200)^2 would be a "certified" zero. The constructor sets
/// rounding to nearest and clears flush-to-zero and denormals-are-zero in this thread, then tries
/// a few operations; the destructor puts the former state back. Make one in every task: the state
/// belongs to a thread.
///
/// Throws std::runtime_error if these operations do not round as they should.
class [[nodiscard]] FloatingPointEnvironment {
 public:
  FloatingPointEnvironment();
  ~FloatingPointEnvironment();
  FloatingPointEnvironment(const FloatingPointEnvironment&) = delete;
  FloatingPointEnvironment& operator=(const FloatingPointEnvironment&) = delete;

 private:
  std::fenv_t former_{};
};

/// Whether this thread now rounds to nearest and keeps subnormal results and operands.
bool floating_point_environment_is_sound() noexcept;

}  // namespace tensortopo
