// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_gaps.hpp"

#include "interval_tensors.hpp"

namespace tensortopo {

std::optional<CriticalGaps> critical_gaps(const CellCriticalPoints& points, const ModeValue& mode,
                                          double widest) {
  const detail::UpwardRounding upward;
  const detail::Range own = detail::gap_of(mode);
  if (mode.sign() == 0 || !points.are_independent || !(own.sup() < widest)) return std::nullopt;
  CriticalGaps gaps{widest, true};
  for (const auto& of_dimension : points.of_dimension)
    for (const CriticalPoint& point : of_dimension) {
      const bool has_other_sign = mode.sign() > 0 ? point.high < 0 : point.low > 0;
      if (has_other_sign || point.gap_low >= gaps.open_until) continue;
      if (point.gap_high < own.inf()) {
        gaps.none_beyond = false;
      } else if (point.gap_low > own.sup()) {
        gaps.open_until = point.gap_low;
      } else {
        return std::nullopt;
      }
    }
  return gaps;
}

}  // namespace tensortopo
