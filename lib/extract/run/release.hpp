// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <vector>

namespace tensortopo {

/// Gives back the memory of what nobody reads any more. (`vector = {}` would keep the room.)
template <class... Values>
void release(Values&... values) {
  ((values = Values()), ...);
}

/// The same of a list whose values hold memory of their own, which several threads give back.
template <class Value>
void release_each(std::vector<Value>& values) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), 1024),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i)
                        values[i] = Value();
                    });
  release(values);
}

}  // namespace tensortopo
