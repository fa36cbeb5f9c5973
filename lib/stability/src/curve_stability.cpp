// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "stable_cells.hpp"
#include "tensortopo/stability/level_stability.hpp"
#include "transverse_part.hpp"

namespace tensortopo {

LevelStability curve_stability(const UncertainField& field, Degeneracy kind,
                               const ExtractOptions& options) {
  stability::CellTests tests;
  const bool is_planar = kind == Degeneracy::planar;
  tests.lode_angle = is_planar ? std::numbers::pi / 3 : 0;
  tests.vertex = [&](const stability::Traceless&, std::size_t v) {
    return std::abs(field.lode_angles[v] - tests.lode_angle) >
           field.turns[v] + 4 * stability::kAngleError;
  };
  // Planar degenerate tensors are the opposite of linear ones.
  const auto is_regular = [is_planar](auto simplex, int parts) {
    if (is_planar)
      for (auto& tensor : simplex.tensors) tensor = -1.0 * tensor;
    const auto test = [&](const auto& part) { return stability::is_transverse(simplex, part); };
    return stability::holds_in_parts(simplex, parts, test, test);
  };
  tests.edge = is_regular, tests.face = is_regular, tests.tet = is_regular;
  tests.reasons = {Stability::degenerate_vertex, Stability::degenerate_edge,
                   Stability::points_of_face, Stability::arcs_of_tet};
  return stability::stable_cells(field, tests, options);
}

}  // namespace tensortopo
