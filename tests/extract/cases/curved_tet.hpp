// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "extract/patch/patch.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract_case.hpp"

namespace tensortopo::test {

/// A tetrahedron of its own, with its curves.
struct CurvedTet {
  CurvedTet(const TetTensors& tensors, const ModeValue& mode) : simplex_case(tensors, mode) {
    constexpr std::array<std::array<std::uint8_t, 3>, 4> faces{
        {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
    tet.simplex = simplex_case.simplex;
    tet.face_vertices = faces;
    tet.outward = {true, false, true, false};
    tet.edge_forward.fill(true);
    for (std::size_t f = 0; f < 4; ++f) {
      const auto [i, j, k] = faces[f];
      const auto& level = simplex_case.level;
      const auto a = edge_crossings(simplex_case.edge(i, j), level);
      const auto b = edge_crossings(simplex_case.edge(i, k), level);
      const auto c = edge_crossings(simplex_case.edge(j, k), level);
      if (!a || !b || !c) return;
      auto found = face_curves(simplex_case.face(i, j, k), {*a, *b, *c}, level, {});
      if (!found) return;
      arcs[f] = std::move(*found);
      tet.arcs[f] = arcs[f];
    }
    has_curves = true;
  }
  CurvedTet(const CurvedTet&) = delete;
  CurvedTet& operator=(const CurvedTet&) = delete;

  SimplexCase<double, 4> simplex_case;
  std::array<std::vector<FaceArc<double>>, 4> arcs;
  TetWithCurves<double> tet;
  bool has_curves = false;
};

/// Which loops bound which sheet.
inline std::vector<std::pair<LoopNumbers, int>> in_order(const Sheets& sheets) {
  std::vector<std::pair<LoopNumbers, int>> result;
  for (const auto& sheet : sheets) {
    auto loops = sheet.loops;
    std::sort(loops.begin(), loops.end());
    result.emplace_back(loops, sheet.euler_characteristic);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tensortopo::test
