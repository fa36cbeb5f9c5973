// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/scalar/floating_point_environment.hpp"

#include <limits>
#include <stdexcept>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tensortopo {
namespace {

/// Lets results and operands be subnormal. glibc's fenv_t holds the control word that is changed
/// here, so restoring it restores these bits too.
void keep_subnormals() noexcept {
#if defined(__SSE2__)
  constexpr unsigned flush_to_zero = 0x8000u;
  constexpr unsigned denormals_are_zero = 0x0040u;
  _mm_setcsr(_mm_getcsr() & ~(flush_to_zero | denormals_are_zero));
#elif defined(__aarch64__)
  unsigned long control;
  __asm__ volatile("mrs %0, fpcr" : "=r"(control));
  control &= ~(1ul << 24);
  __asm__ volatile("msr fpcr, %0" : : "r"(control));
#endif
}

}  // namespace

bool floating_point_environment_is_sound() noexcept {
  // Volatile: the compiler must neither fold these nor move them across a change of the state.
  volatile double one = 1, half_ulp = std::numeric_limits<double>::epsilon() / 2;
  volatile double smallest_normal = std::numeric_limits<double>::min(), half = 0.5, two = 2;
  volatile double three_halves = 1.5;
  volatile double above = one + half_ulp;
  volatile double below = -one - half_ulp;
  volatile double truncated = one + half_ulp * three_halves;
  const bool to_nearest =
      above == 1 && below == -1 && truncated == 1 + std::numeric_limits<double>::epsilon();
  volatile double subnormal = smallest_normal * half;
  volatile double back = subnormal * two;
  // Comparing with zero would be blind to operands that are flushed: doubling is not.
  return to_nearest && back == std::numeric_limits<double>::min();
}

FloatingPointEnvironment::FloatingPointEnvironment() {
  std::fegetenv(&former_);
  std::fesetround(FE_TONEAREST);
  keep_subnormals();
  if (!floating_point_environment_is_sound()) {
    std::fesetenv(&former_);
    throw std::runtime_error(
        "double arithmetic on this thread does not round to nearest with subnormal numbers");
  }
}

FloatingPointEnvironment::~FloatingPointEnvironment() { std::fesetenv(&former_); }

}  // namespace tensortopo
