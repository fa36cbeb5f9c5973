// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tensortopo {

/// How many cells the refinement of a simplex of the mesh may take. A small budget settles nearly
/// everything. Where the level is next to a critical value no number would, so that is looked at
/// before the regular one is spent. The large one is for thin tubes, next to modes 1 and -1, whose
/// cells are as small as the tubes are thin.
enum class Budget { small, regular, large };

/// A tube along the whole of a face takes some 100 (1 - mode^2)^(-1/4) cells: at the modes next to
/// 1 and -1, whose signs take 50 digits, the large budget is hardly larger than the regular one.
inline std::size_t face_cell_limit(Budget budget, double gap) {
  constexpr double kNarrowest = 1e-15;
  const bool in_reach = gap > kNarrowest;
  return budget != Budget::large ? 5000 : in_reach ? 1000000 : 10000;
}

/// Tubes so thin that the large budget is never enough get the regular one, and those for which
/// that is never enough a tenth of it. Cells along a tube grow in number like (1 - mode^2)^(-1/4):
/// with the least factor seen, 29, they are more than 50,000 from 1 - mode^2 = 1e-13 on.
inline std::size_t tet_cell_limit(Budget budget, double gap) {
  constexpr double kNarrowest = 2e-7, kNarrowestOfRegular = 1e-13;
  if (!(gap > kNarrowestOfRegular)) return 5000;
  if (budget == Budget::small) return 10000;
  return budget == Budget::regular || !(gap > kNarrowest) ? 50000 : 500000;
}

/// Whether the refinement of a tetrahedron is no other with a large budget than with the usual one.
inline bool is_budget_spent(Budget budget, double gap) {
  return budget == Budget::large &&
         tet_cell_limit(budget, gap) == tet_cell_limit(Budget::regular, gap);
}

}  // namespace tensortopo
