// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "thin_sheets.hpp"

#include <utility>

#include "exact_tensors.hpp"
#include "extractor_scalars.hpp"
#include "tensortopo/field/critical_gaps.hpp"

namespace tensortopo {

template <class Scalar>
bool is_thin(const Level<Scalar>& level) {
  return 8 * static_cast<double>(Scalar(1) - level.mu_squared) < detail::widest_gap();
}

template <class Scalar>
std::optional<ThinSheets> sheets_of_thin_level(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const std::vector<std::vector<RimPiece>>& loops,
                                               Effort effort) {
  const auto tensors = detail::exact_tensors(tet.simplex);
  const auto gaps = critical_gaps(tensors, level.value, detail::widest_gap());
  if (gaps && gaps->none_beyond)
    if (auto sheets = detail::tubes(tet, level, loops)) return sheets;
  if (auto sheets = detail::counted_sheets(tet, level, loops))
    return ThinSheets{std::move(*sheets), {}};
  std::optional<std::vector<SheetTopology>> sheets;
  if (gaps) sheets = detail::sheets_of_thicker_level(tet, level, loops, gaps->open_until, effort);
  // Elsewhere a refinement comes first; with great effort this has been tried.
  if (!sheets && effort == Effort::usual && is_effort_spent(Effort::great, level))
    sheets = detail::sheets_counted_with_effort(tet, level, loops);
  if (!sheets) return std::nullopt;
  return ThinSheets{std::move(*sheets), {}};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                     \
  template bool is_thin(const Level<Scalar>&);             \
  template std::optional<ThinSheets> sheets_of_thin_level( \
      const TetWithCurves<Scalar>&, const Level<Scalar>&,  \
      const std::vector<std::vector<RimPiece>>&, Effort);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
