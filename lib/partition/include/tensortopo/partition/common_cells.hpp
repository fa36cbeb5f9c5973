// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Surfaces and curves of one mesh as extractions from those of its tetrahedra that any of them
/// needs.
struct CommonCells {
  TetMesh cells;                         ///< ascending by id, with `cell_ids`
  std::vector<std::int64_t> vertex_ids;  ///< of the points of `cells`, ascending
  /// In the order given, in numbers of `cells`; of `statistics` as `extraction_of`.
  std::vector<std::variant<Extraction, CurveExtraction>> levels;
};

/// @param merged  of one mesh; they are moved out, one after the other
/// @throws std::invalid_argument if a vertex has two places or tensors
CommonCells in_common_cells(std::vector<std::variant<MergedSurface, MergedCurves>> merged);

}  // namespace tensortopo
