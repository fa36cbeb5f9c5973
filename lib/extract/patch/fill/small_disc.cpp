// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/small_disc.hpp"

#include <algorithm>
#include <cmath>

#include "extract/patch/fill/polygon.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

bool is_small_disc(const SheetTopology& sheet, std::span<const BoundaryVertex> boundary,
                   const Sampling& sampling) {
  if (sheet.euler_characteristic != 1 || boundary.size() > kSmallPolygon) return false;
  const double least = elementary::cos(std::min(1.5 * sampling.largest_turn(), 1.5));
  const double least_dominant = elementary::cos(std::min(3 * sampling.largest_turn(), 1.5));
  for (const auto& v : boundary)
    if (!(line_cosine(v.medium, boundary[0].medium) > least) ||
        !(line_cosine(v.dominant, boundary[0].dominant) > least_dominant))
      return false;
  return true;
}

}  // namespace tensortopo
