// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/tubes.hpp"

#include <array>

#include "extract/level/exact_tensors.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/regions/closed_curves.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"

namespace tensortopo::detail {

template <class Scalar>
std::optional<NearDegenerateSheets> tubes(const TetWithCurves<Scalar>& tet,
                                          const Level<Scalar>& level, const BoundaryLoops& loops) {
  // The loop of each closed curve.
  std::array<std::vector<int>, 4> loop_of_arc;
  for (std::size_t f = 0; f < 4; ++f) loop_of_arc[f].assign(tet.arcs[f].size(), -1);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const auto& piece = loops[l][0];
    const auto f = static_cast<std::size_t>(piece.face), a = static_cast<std::size_t>(piece.arc);
    if (!tet.arcs[f][a].closed) return std::nullopt;
    loop_of_arc[f][a] = static_cast<int>(l);
  }
  const auto tensors = detail::exact_tensors(tet.simplex);
  auto arcs = degenerate_arcs(tensors, tet.simplex.exponents, level.value);
  if (!arcs) return std::nullopt;
  std::array<std::size_t, 4> ends{};
  for (const auto& arc : *arcs)
    for (const auto& end : arc.ends) ++ends[static_cast<std::size_t>(end.face)];
  for (std::size_t f = 0; f < 4; ++f)
    if (ends[f] != tet.arcs[f].size()) return std::nullopt;

  std::array<std::optional<ClosedCurves<Scalar>>, 4> curves;
  NearDegenerateSheets result;
  for (const auto& arc : *arcs) {
    SheetTopology sheet;
    sheet.euler_characteristic = 0;
    for (const auto& end : arc.ends) {
      const auto f = static_cast<std::size_t>(end.face);
      int curve = 0;
      if (tet.arcs[f].size() > 1) {
        const auto& v = tet.face_vertices[f];
        if (!curves[f]) curves[f].emplace(part_of_simplex<3>(tet.simplex, v), level, tet.arcs[f]);
        curve = curves[f]->take({end.weights[v[0]], end.weights[v[1]], end.weights[v[2]]});
      }
      if (curve < 0) return std::nullopt;
      sheet.loops.push_back(loop_of_arc[f][static_cast<std::size_t>(curve)]);
    }
    result.sheets.push_back(std::move(sheet));
  }
  result.tubes = std::move(*arcs);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                             \
  template std::optional<NearDegenerateSheets> tubes(const TetWithCurves<Scalar>&, \
                                                     const Level<Scalar>&, const BoundaryLoops&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
