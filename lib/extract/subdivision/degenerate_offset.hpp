// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/tensor/deviator.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo::detail {

/// The eigenvector of the simple eigenvalue of a tensor next to a degenerate one, unit, about.
/// @param sign of the mode
Vector3<double> simple_eigenvector(const Deviator<double>& t, int sign);

/// What a tensor, brought to norm one, has more than the degenerate tensor next to it. It is in the
/// plane of the two eigenvectors whose eigenvalues are nearly the same, and its norm is half their
/// difference times the root of two.
Deviator<double> degenerate_offset(const Deviator<double>& t, int sign);

/// How far a chord of a level next to the degenerate curve leaves it, over the distance of the
/// level from the curve: what the offset at a place on the chord has more than the mean of those at
/// its ends, which it is beside a straight curve.
/// @param first, last  tensors at the ends of the chord
double sag_of_chord(const Deviator<double>& first, const Deviator<double>& last, int sign);

/// Chords are to sag by at most so much, if so many halvings are enough.
inline constexpr double kLargestSag = 0.5;
inline constexpr int kMostSagHalvings = 8;

/// How often a chord is to be halved so that it does not sag by more; each halving leaves a
/// quarter. None if it would be too often.
int sag_halvings(double sag, int most = kMostSagHalvings);

}  // namespace tensortopo::detail
