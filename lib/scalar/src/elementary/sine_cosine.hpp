// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "double_double.hpp"

namespace tensortopo::elementary {

/// Sine and cosine to twice the precision.
struct SineCosine {
  DoubleDouble sin, cos;
  double sin_error = 0, cos_error = 0;  ///< bounds
};

/// The largest angle that `sine_cosine` takes.
inline constexpr double kLargestAngle = 0x1p16;

/// Errors are below 2^-90, and for angles below pi/32 that of the sine is below 2^-90 times its
/// value; for angles up to pi also near the zeros of the two, of the value.
/// @pre |x| <= kLargestAngle
SineCosine sine_cosine(double x);

/// The same in a fraction of the time: errors are below 2^-60, and for angles below pi/32 that of
/// the sine is below 2^-58 times the angle.
/// @pre |x| <= kLargestAngle
SineCosine sine_cosine_of_few_digits(double x);

}  // namespace tensortopo::elementary
