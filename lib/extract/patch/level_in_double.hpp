// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/level/level.hpp"

namespace tensortopo {

/// What `level_slope` needs of a level, rounded.
template <class Scalar>
Level<double> level_in_double(const Level<Scalar>& level) {
  Level<double> result;
  result.mu = static_cast<double>(level.mu);
  result.sqrt2 = static_cast<double>(level.sqrt2);
  return result;
}

}  // namespace tensortopo
