// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/common_cells.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "crossed_cells.hpp"
#include "levels/renumber_level.hpp"
#include "tensortopo/partition/certify_pieces.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using MergedLevel = std::variant<MergedSurface, MergedCurves>;

NumberedCells cells_of_level(const MergedLevel& level) {
  return std::visit([](const auto& m) { return NumberedCells{m.cells, m.vertex_ids}; }, level);
}

/// Where ids are among all, ascending.
std::vector<Index> places_of(const std::vector<std::int64_t>& ids,
                             const std::vector<std::int64_t>& all) {
  std::vector<Index> places;
  for (const std::int64_t id : ids)
    places.push_back(
        static_cast<Index>(std::lower_bound(all.begin(), all.end(), id) - all.begin()));
  return places;
}

/// Those of all levels, each once.
TetMesh united_cells(const CrossedCells& all) {
  const TetMesh sorted = all.sorted();
  TetMesh cells{sorted.points, sorted.tensors, {}, {}};
  for (std::size_t t = 0; t < sorted.tets.size(); ++t) {
    if (t > 0 && sorted.cell_ids[t] == sorted.cell_ids[t - 1]) continue;
    cells.tets.push_back(sorted.tets[t]);
    cells.cell_ids.push_back(sorted.cell_ids[t]);
  }
  return cells;
}

}  // namespace

CommonCells in_common_cells(std::vector<MergedLevel> merged) {
  CommonCells result;
  std::vector<NumberedCells> of_levels;
  for (const MergedLevel& level : merged) of_levels.push_back(cells_of_level(level));
  CrossedCells all = crossed_cells(std::span<const NumberedCells>(of_levels));
  result.cells = united_cells(all);
  result.vertex_ids = std::move(all.vertex_ids);
  for (std::size_t i = 0; i < merged.size(); ++i) {
    const auto vertices = places_of(of_levels[i].vertex_ids, result.vertex_ids);
    const auto tets = places_of(of_levels[i].cells.cell_ids, result.cells.cell_ids);
    std::visit(
        [&](const auto& level) {
          auto extraction = extraction_of(level);
          renumber_level(extraction, vertices, tets);
          result.levels.emplace_back(std::move(extraction));
        },
        merged[i]);
    merged[i] = MergedSurface{};
  }
  return result;
}

}  // namespace tensortopo
