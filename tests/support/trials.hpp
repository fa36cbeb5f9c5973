// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

namespace tensortopo::test {

/// The environment variable TENSORTOPO_TEST_MULTIPLIER (of the short suite: a third), or 1.
inline double multiplier() {
  const char* text = std::getenv("TENSORTOPO_TEST_MULTIPLIER");
  const double factor = text != nullptr ? std::atof(text) : 1;
  return factor > 0 ? factor : 1;
}

/// A number of trials times the multiplier; at least so many, where fewer show too little.
inline int trials(int count, int least = 1) {
  return std::max(least, static_cast<int>(count * multiplier()));
}

/// Is this the short suite, which tries fewer inputs?
inline bool is_short() { return multiplier() < 1; }

/// What is tried, or less in the short suite.
template <class T>
T full_or_short(T full, T less) {
  return is_short() ? std::move(less) : std::move(full);
}

/// Which inputs of a list are tried: all, but in the short suite only the first of each kind and
/// every `step`th after it.
class Share {
 public:
  explicit Share(std::size_t step) : step_(is_short() ? step : 1) {}
  bool has(const std::string& kind) { return seen_[kind]++ % step_ == 0; }

 private:
  std::size_t step_;
  std::map<std::string, std::size_t> seen_;
};

}  // namespace tensortopo::test
