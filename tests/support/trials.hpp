// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>

namespace tensortopo::test {

/// A number of trials times the environment variable TENSORTOPO_TEST_MULTIPLIER (of the short suite: a
/// half).
inline int trials(int count) {
  const char* text = std::getenv("TENSORTOPO_TEST_MULTIPLIER");
  const double factor = text != nullptr ? std::atof(text) : 1;
  return std::max(1, static_cast<int>(count * (factor > 0 ? factor : 1)));
}

}  // namespace tensortopo::test
