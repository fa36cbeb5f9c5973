// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::test {

/// Where {mode = mu + 0} meets the segment of tensors from s to t, by Sturm sequences in rational
/// arithmetic: intervals that each hold one crossing, in order, and in which direction it goes.
struct ExactCrossing {
  double low, high;  ///< parameters along the segment, 0 at s and 1 at t
  bool rising;       ///< the mode passes mu upwards
};

/// A root of even multiplicity counts as none from below and as two (one interval, given twice)
/// from above. Requires that the deviators at both ends and all points between do not vanish.
std::vector<ExactCrossing> exact_crossings(const SymmetricTensor<double>& s,
                                           const SymmetricTensor<double>& t,
                                           const ModeValue& mode);

}  // namespace tensortopo::test
