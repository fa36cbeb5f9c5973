// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/near_degenerate_sheets.hpp"

#include <utility>

#include "extract/level/exact_tensors.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/isotopic_level.hpp"
#include "extract/topology/regions/counted_sheets.hpp"
#include "tensortopo/field/critical_gaps.hpp"

namespace tensortopo {

template <class Scalar>
std::optional<NearDegenerateSheets> sheets_of_near_degenerate_level(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, const BoundaryLoops& loops,
    Budget budget) {
  const auto points = cell_critical_points(detail::exact_tensors(tet.simplex));
  const auto gaps = critical_gaps(points, level.value, detail::widest_gap());
  if (gaps && gaps->none_beyond)
    if (auto sheets = detail::tubes(tet, level, loops)) return sheets;
  if (auto sheets = detail::counted_sheets(tet, points, level, loops))
    return NearDegenerateSheets{std::move(*sheets), {}};
  std::optional<Sheets> sheets;
  if (gaps)
    sheets = detail::sheets_of_wider_isotopic_level(tet, level, loops, gaps->open_until, budget);
  // Elsewhere a refinement comes first; with a large budget this has been tried.
  if (!sheets && budget == Budget::regular && is_budget_spent(Budget::large, level.gap()))
    sheets = detail::sheets_counted_from_distant_level(tet, level, loops);
  if (!sheets) return std::nullopt;
  return NearDegenerateSheets{std::move(*sheets), {}};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                          \
  template std::optional<NearDegenerateSheets> sheets_of_near_degenerate_level( \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&, Budget);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
