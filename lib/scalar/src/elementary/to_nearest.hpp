// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpfr.h>

#include "double_double.hpp"

namespace tensortopo::elementary {

/// A number of MPFR that lives in its scope.
class MpfrNumber {
 public:
  explicit MpfrNumber(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  explicit MpfrNumber(double x) : MpfrNumber(mpfr_prec_t{53}) { mpfr_set_d(value_, x, MPFR_RNDN); }
  MpfrNumber(const MpfrNumber&) = delete;
  MpfrNumber& operator=(const MpfrNumber&) = delete;
  ~MpfrNumber() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// The double nearest to what `compute` gives.
///
/// More bits than a double has, cut off, with the last one set if anything was lost ("rounding to
/// odd"): rounding that once more is as rounding the true value, also to a subnormal number.
/// @param compute  compute(result): a function of MPFR, rounded toward zero; returns its ternary
///                 value
template <class Compute>
double nearest_of(const Compute& compute) {
  constexpr mpfr_prec_t kBits = 120;
  MpfrNumber result(kBits);
  const int ternary = compute(result.get());
  if (ternary != 0 && mpfr_regular_p(result.get()) != 0 && mpfr_min_prec(result.get()) < kBits) {
    if (mpfr_sgn(result.get()) > 0)
      mpfr_nextabove(result.get());
    else
      mpfr_nextbelow(result.get());
  }
  return mpfr_get_d(result.get(), MPFR_RNDN);
}

/// The double nearest to a number within `error` of `value`: if all such numbers have the same, and
/// else what `otherwise` gives.
template <class Otherwise>
double nearest_within(const DoubleDouble& value, double error, const Otherwise& otherwise) {
  const double low = value.hi + (value.lo - error), high = value.hi + (value.lo + error);
  return low == high ? low : otherwise();
}

/// Of a value of which 2^-85 bounds the relative error: the computations here leave a factor of
/// more than a hundred.
inline constexpr double kRelativeError = 0x1p-85;

}  // namespace tensortopo::elementary
