// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where vertices lie, up to the rounding of their coordinates.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>

namespace certificate {

using Point3 = std::array<double, 3>;

/// How much rounding may move a coordinate of a point of a simplex: 2^-50 of the largest, in
/// modulus, that a corner has on that axis.
///
/// A point is computed as the sum of w_i P_i, of at most four terms. With weights of which one is 1
/// less the others they sum up to 1 but for three roundings of 2^-53, and the products and sums are
/// off by four more: together by less than 8 times 2^-53 of the largest |P_i|.
constexpr double kRounding = 0x1p-50;

/// The same with what is lost below the least normal number: some units of 2^-1074.
constexpr double rounding_of(double largest) { return largest * kRounding + 0x1p-1070; }

/// Weights of about the point of a simplex' plane that is nearest to x, those below zero put to
/// zero; in doubles, not more than near.
/// @pre 2 to 4 corners
std::array<double, 4> weights_near(const Point3& x, std::span<const Point3> corners);

/// Does a point of the simplex differ from x by no more than rounding, on each axis?
/// @pre 1 to 4 corners
bool lies_in(const Point3& x, std::span<const Point3> corners);

/// Does a point a + t (b - a), for a t between the two, differ from x by no more than rounding?
bool lies_between(const Point3& x, const Point3& a, const Point3& b, const mpq_class& from,
                  const mpq_class& to);

}  // namespace certificate
