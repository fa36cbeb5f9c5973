// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/scalar/elementary.hpp"
/// \file
/// Elementary functions whose results no C library, compiler or processor changes.
///
/// The standard prescribes the bits of + - * / and square roots, but not those of sin or exp: C
/// libraries differ in last bits, also one library on processors with and without FMA. These
/// functions are correctly rounded: the result is the double nearest to the true value (of two the
/// even one), special values as in C. A double-double value with an error bound decides nearly all
/// arguments, MPFR the others (Ziv's strategy), so no result depends on the C library.
/// For templates: `using elementary::sin;` in place of `using std::sin;`, other scalars bring
/// functions of their own.
///
/// Requires    rounding to nearest.
/// Checked by  tests/scalar/test_elementary.cpp
namespace tensortopo::elementary {

/// The sine of an angle in radians.
double sin(double x);
/// The cosine of an angle in radians.
double cos(double x);
/// The tangent of an angle in radians.
double tan(double x);

/// The angle in [-pi/2, pi/2] with this sine; NaN outside of [-1, 1].
double asin(double x);
/// The angle in [0, pi] with this cosine; NaN outside of [-1, 1].
double acos(double x);
/// The angle in [-pi/2, pi/2] with this tangent.
double atan(double x);

/// The angle of the point (x, y), in [-pi, pi].
double atan2(double y, double x);

/// The exponential function.
double exp(double x);
/// The natural logarithm; NaN for negative numbers.
double log(double x);
/// The real cube root.
double cbrt(double x);

/// The length of (x, y).
double hypot(double x, double y);
/// The length of (x, y, z).
double hypot(double x, double y, double z);

}  // namespace tensortopo::elementary
