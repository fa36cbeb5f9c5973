// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/counted_sheets.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "extract/level/proofs/is_above.hpp"
#include "extract/level/exact_tensors.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/regions/superlevel_paths.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"
#include "tensortopo/field/level_count.hpp"

namespace tensortopo::detail {

namespace {

/// Whether the mode is nowhere 0 in the tetrahedron, and of the sign given.
template <class Scalar>
bool has_mode_of_sign(const LevelSimplex<Scalar, 4>& tet, int sign) {
  const Scalar norm = largest_norm(tet.tensors);
  const auto forms = mode_forms(tet.tensors);
  return has_strict_sign(forms.determinant, sign,
                         Scalar(kDeterminantBound) * rounding_unit(norm, 1.0) * norm * norm *
                             norm) == Verdict::positive;
}

SheetTopology sheet_of(LoopNumbers loops, int euler_characteristic) {
  SheetTopology sheet;
  sheet.loops = std::move(loops);
  sheet.euler_characteristic = euler_characteristic;
  return sheet;
}

/// What boundary loops bound if the Euler characteristic of all sheets together leaves no choice.
/// Every sheet has a loop: there are at most as many, and only discs have an Euler characteristic
/// of one for each.
std::optional<Sheets> sheets_of(std::size_t loops, const LevelCount& count) {
  const int n = static_cast<int>(loops), chi = count.level();
  Sheets sheets;
  if (chi == n)
    for (int l = 0; l < n; ++l) sheets.push_back(sheet_of({l}, 1));
  else if (n == 1)
    sheets.push_back(sheet_of({0}, chi));
  else if (n == 2 && chi == 0 && count.bridges == 0)
    sheets.push_back(sheet_of({0, 1}, 0));
  return sheets.empty() ? std::nullopt : std::optional(std::move(sheets));
}

/// The sheets if each loop bounds a disc in the superlevel set on the boundary, and paths join
/// these. The part in the superlevel set has as many pieces as joined discs, or fewer, and no
/// voids; if its Euler characteristic is that number it has no handles either, so its pieces are
/// balls, and what is left of the surface of each without its discs is one sheet.
///
/// @param nearer what is counted on the other side of the level, all of it
template <class Scalar>
std::optional<Sheets> joined_sheets(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                    const BoundaryLoops& loops, const LevelCount& nearer,
                                    Search search) {
  const int n = static_cast<int>(loops.size());
  // On the boundary, a sphere, the other side is one piece with n holes.
  if (nearer.boundary != 2 - n) return std::nullopt;
  const int superlevel = 1 - nearer.inside + nearer.level();
  if (superlevel < 1 || superlevel > n) return std::nullopt;
  const auto part = loops_joined_in_superlevel_set(tet, level, loops, superlevel, search);
  std::map<int, LoopNumbers> parts;
  for (int l = 0; l < n; ++l) parts[part[static_cast<std::size_t>(l)]].push_back(l);
  if (static_cast<int>(parts.size()) != superlevel) return std::nullopt;
  Sheets sheets;
  for (auto& [number, own] : parts)
    sheets.push_back(sheet_of(own, 2 - static_cast<int>(own.size())));
  return sheets;
}

/// Euler characteristics of what is on one side of a level in a refined tetrahedron, and on its
/// boundary. Cells, their faces and edges are simple: what is on that side of one of them is all of
/// it, nothing, or a ball that the rest of its boundary meets in a ball. So only those with all
/// vertices on that side count.
template <class Scalar>
LevelCount counted_by_cells(const Refinement<Scalar, 4>& refinement, bool above) {
  const auto& vertices = refinement.vertices();
  std::set<std::vector<std::uint32_t>> simplices;
  for (const auto& cell : refinement.cells()) {
    if (!cell.alive) continue;
    std::vector<std::uint32_t> kept;
    for (const auto v : cell.vertices)
      if (vertices[v].above == above) kept.push_back(v);
    std::sort(kept.begin(), kept.end());
    for (unsigned chosen = 1; chosen < 1u << kept.size(); ++chosen) {
      std::vector<std::uint32_t> simplex;
      for (std::size_t i = 0; i < kept.size(); ++i)
        if (chosen >> i & 1) simplex.push_back(kept[i]);
      simplices.insert(std::move(simplex));
    }
  }
  LevelCount count;
  for (const auto& simplex : simplices) {
    const int cell = simplex.size() % 2 == 1 ? 1 : -1;
    count.inside += cell;
    for (std::size_t f = 0; f < 4; ++f)
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](auto v) { return vertices[v].weights[f] == 0; })) {
        count.boundary += cell;
        break;
      }
  }
  return count;
}

/// What is on the side of the level without its curve, from what a refinement finds at a level far
/// from all curves and the critical points between the two.
template <class Scalar>
std::optional<LevelCount> counted_from_afar(const TetWithCurves<Scalar>& tet,
                                            const CellCriticalPoints& points,
                                            const Level<Scalar>& level) {
  const auto afar = ModeValue::parse(level.sign < 0 ? "-1/2" : "1/2");
  auto count = count_change(points, afar, level.value, -level.sign);
  if (!count) return std::nullopt;
  const auto far_level = make_level<Scalar>(afar);
  auto simplex = tet.simplex;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<double, 4> corner{};
    corner[i] = 1;
    simplex.above[i] = is_above(tet.simplex, tet.simplex.tensors[i], corner, far_level);
  }
  Refinement<Scalar, 4> refinement(simplex, far_level);
  if (!refinement.run(tet_cell_limit(Budget::regular, far_level.gap()))) return std::nullopt;
  const auto there = counted_by_cells(refinement, level.sign < 0);
  count->inside += there.inside, count->boundary += there.boundary;
  return count;
}

}  // namespace

template <class Scalar>
std::optional<Sheets> sheets_counted_from_distant_level(const TetWithCurves<Scalar>& tet,
                                                        const Level<Scalar>& level,
                                                        const BoundaryLoops& loops) {
  const auto points = cell_critical_points(detail::exact_tensors(tet.simplex));
  std::optional<LevelCount> count;
  if (has_mode_of_sign(tet.simplex, level.sign))
    count = count_level(points, level.value, -level.sign);
  if (!count) count = counted_from_afar(tet, points, level);
  if (!count) return std::nullopt;
  count->bridges = 1;  // for all that is known
  if (auto sheets = sheets_of(loops.size(), *count)) return sheets;
  return joined_sheets(tet, level, loops, *count, Search::everything);
}

template <class Scalar>
std::optional<Sheets> counted_sheets(const TetWithCurves<Scalar>& tet,
                                     const CellCriticalPoints& points, const Level<Scalar>& level,
                                     const BoundaryLoops& loops) {
  // Away from the degenerate curve next to the level there is most often no other.
  if (has_mode_of_sign(tet.simplex, level.sign))
    if (const auto count = count_level(points, level.value, -level.sign)) {
      if (auto sheets = sheets_of(loops.size(), *count)) return sheets;
      if (auto sheets = joined_sheets(tet, level, loops, *count, Search::chords)) return sheets;
    }
  if (!degenerate_arcs(detail::exact_tensors(tet.simplex), tet.simplex.exponents, level.value)) return std::nullopt;
  const auto count = count_level(points, level.value, level.sign);
  return count ? sheets_of(loops.size(), *count) : std::nullopt;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template std::optional<Sheets> counted_sheets(const TetWithCurves<Scalar>&,                    \
                                                const CellCriticalPoints&, const Level<Scalar>&, \
                                                const BoundaryLoops&);                           \
  template std::optional<Sheets> sheets_counted_from_distant_level(                              \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
