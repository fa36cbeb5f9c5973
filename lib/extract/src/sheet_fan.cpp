// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

template <class Scalar>
bool mesh_as_fan(const TetPlan<Scalar>& plan, const SheetTopology& sheet,
                 const FaceArcVertices& vertices, const Level<Scalar>& level,
                 TetTriangles<Scalar>& out) {
  if (!plan.leaves || sheet.euler_characteristic != 1 || sheet.loops.size() != 1) return false;
  const auto& leaves = *plan.leaves;
  // The node farthest inside: the least of its weights is largest.
  InnerVertex<Scalar> best;
  Scalar depth(0);
  for (const auto& polygon : leaves.mesh.polygons) {
    if (polygon.component != sheet.component) continue;
    for (int k = 0; k < polygon.size; ++k) {
      const auto& node = leaves.mesh.nodes[polygon.nodes[static_cast<std::size_t>(k)]];
      if (node.faces != 0) continue;
      const auto point = node_point(leaves.refinement, node, level);
      Scalar total(0);
      for (const Scalar& w : point.weights) total += w;
      const Scalar least = *std::min_element(point.weights.begin(), point.weights.end()) / total;
      if (least > depth) depth = least, best = point;
    }
  }
  if (!(depth > Scalar(0))) return false;
  const auto centre = -1 - static_cast<std::int32_t>(out.inner.size());
  out.inner.push_back(best);
  const auto rim =
      loop_vertices(plan.loops[static_cast<std::size_t>(sheet.loops[0])], vertices);
  for (std::size_t i = 0; i < rim.size(); ++i)
    out.triangles.push_back({rim[i].id, rim[(i + 1) % rim.size()].id, centre});
  return rim.size() > 2;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                               \
  template bool mesh_as_fan(const TetPlan<Scalar>&, const SheetTopology&,            \
                            const FaceArcVertices&, const Level<Scalar>&, TetTriangles<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
