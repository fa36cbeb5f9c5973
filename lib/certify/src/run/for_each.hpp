// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo::detail {

/// Calls `body` for 0 to count - 1, in parallel, in the library's floating-point environment.
template <class Body>
void for_each(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace tensortopo::detail
