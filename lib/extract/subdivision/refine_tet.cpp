// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/refine_tet.hpp"

#include "extract/level/near_degenerate_level.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/saddle_places.hpp"

namespace tensortopo::detail {

namespace {

/// Cells before lines of saddles are looked for, which takes as long as some hundreds of them.
constexpr std::size_t kBeforeSaddles = 1000;

/// Cells along such a line, with a small budget.
constexpr std::size_t kAlongSaddles = 3000;

/// Where no line was found and cells by angles were not enough, cells by the Hessian metric often
/// are, and then few of them.
constexpr std::size_t kLast = 5000;

/// The square of an angle: smaller cells are around a single point.
constexpr double kSinglePoint = 0x1p-30;

}  // namespace

template <class Scalar>
bool refine_tet(Refinement<Scalar, 4>& refinement, const LevelSimplex<Scalar, 4>& simplex,
                const Level<Scalar>& level, Budget budget) {
  const std::size_t limit = tet_cell_limit(budget, level.gap());
  refinement.reset(simplex, level);
  // Next to modes 1 and -1 cells have measures of their own.
  if (is_near_degenerate(level)) return refinement.run(limit);
  const bool is_little = budget == Budget::small;
  const double smallest = is_little ? kSinglePoint : 0;
  if (refinement.run(kBeforeSaddles, smallest)) return true;
  const auto saddles = saddle_places(simplex, level);
  // A line that touches an edge has one place, one that crosses the tetrahedron two.
  const bool any = !saddles.empty(), is_crossed = saddles.size() > 1;
  const auto run_along = [&](std::size_t cells) {
    refinement.reset(simplex, level);
    return refinement.run_along_saddles(cells, saddles);
  };
  if (any) {
    if (run_along(is_little ? kAlongSaddles : limit)) return true;
    if (is_little && is_crossed) return false;
    refinement.reset(simplex, level);
  }
  if (refinement.run(limit, smallest)) return true;
  return !is_little && !any && run_along(kLast);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                             \
  template bool refine_tet(Refinement<Scalar, 4>&, const LevelSimplex<Scalar, 4>&, \
                           const Level<Scalar>&, Budget);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
