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

}  // namespace tensortopo::detail
