// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <vector>

#include "curves/kept_lines.hpp"
#include "curves/line_order.hpp"
#include "curves/piece_vertices.hpp"
#include "parts/part_names.hpp"

namespace tensortopo {

PieceCurves restrict_piece(const PieceCurves& piece, const PartNumbers& numbers) {
  const PartNames tets(numbers.tets, "cell"), vertices(numbers.vertices, "vertex");
  PieceCurves result = piece;
  result.owned_ids = part_ids(piece.owned_ids, numbers);
  result.whole_tets = static_cast<std::int64_t>(numbers.tets.size());
  result.told.clear(), result.heard.clear();
  MeshPiece cells{piece.cells, piece.vertex_ids, {}, result.whole_tets};
  for (const std::int64_t id : piece.cells.cell_ids) cells.is_owned.push_back(tets.has(id));
  for (auto* list : {&result.unresolved, &result.special})
    std::erase_if(*list, [&](const OwnedCurveCell& cell) { return !tets.has(cell.cell_id); });
  keep_owned_lines(cells, result);
  gather_cells_of_lines(cells, result);

  const auto number = name_cells_anew(result.cells, result.vertex_ids, tets, vertices);
  for (auto& carrier : result.curves.carrier_vertices) carrier = ranks_of(carrier, number);
  for (auto& line : result.keys.lines) line.cell = ranks_of(line.cell, number);
  for (auto* list : {&result.unresolved, &result.special}) {
    for (OwnedCurveCell& cell : *list) cell.cell_id = tets.of(cell.cell_id);
    std::sort(list->begin(), list->end(),
              [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
  }
  // There is nothing around.
  result.around = lines_around(result.curves, result.cells.cell_ids);
  result.is_shared.assign(result.curves.points.size(), 0);
  result.curves.component = components_of_lines(result);
  return result;
}

}  // namespace tensortopo
