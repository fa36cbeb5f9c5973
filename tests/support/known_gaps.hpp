// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "support/fields/random_fields.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::test {

using LongTensors = std::array<Deviator<Real50>, 4>;
LongTensors field_of(const TetTensors& tensors);

/// The gap 1 - mode^2 of a tensor.
double gap_of(const Deviator<Real50>& t);
/// Whether the mode has this sign, 1 or -1.
bool has_sign(const Deviator<Real50>& t, int sign);

/// The gaps of critical values with one sign, found otherwise than by `critical_gaps`: extrema
/// along edges by sampling, critical points of faces and vertices in 50 digits. The saddle inside is
/// left out.
std::vector<double> known_gaps(const LongTensors& field, int sign);

}  // namespace tensortopo::test
