// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/fan.hpp"

#include <algorithm>

#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

namespace {

/// A point of the level in a cell that it crosses: between the middle of the corners above and that
/// of the others, if these are on different sides.
template <class Scalar>
bool point_in_cell(const Refinement<Scalar, 4>& refinement,
                   const typename Refinement<Scalar, 4>::Cell& cell, const Level<Scalar>& level,
                   InnerVertex<Scalar>& point) {
  std::array<InnerVertex<Scalar>, 2> sides{};
  for (const auto v : cell.vertices) {
    const auto& corner = refinement.vertices()[v];
    auto& side = sides[corner.above ? 1 : 0];
    for (std::size_t i = 0; i < 4; ++i) side.weights[i] += Scalar(corner.weights[i]);
    side.tensor = side.tensor + corner.tensor;
  }
  if (!(level_function(sides[0].tensor, level) < Scalar(0)) ||
      !(level_function(sides[1].tensor, level) > Scalar(0)))
    return false;
  const Scalar f = segment_root(sides[0].tensor, sides[1].tensor, level);
  for (std::size_t i = 0; i < 4; ++i)
    point.weights[i] = sides[0].weights[i] + f * (sides[1].weights[i] - sides[0].weights[i]);
  point.tensor = sides[0].tensor + f * (sides[1].tensor - sides[0].tensor);
  return true;
}

}  // namespace

template <class Scalar>
bool mesh_as_fan(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                 const FaceArcVertices& vertices, const Level<Scalar>& level, Patch<Scalar>& out) {
  if (!proved.subdivision || sheet.euler_characteristic != 1 || sheet.loops.size() != 1)
    return false;
  const auto& subdivision = *proved.subdivision;
  // The point farthest inside: the least of its weights is largest.
  InnerVertex<Scalar> best;
  Scalar depth(0);
  const auto offer = [&](const InnerVertex<Scalar>& point) {
    Scalar total(0);
    for (const Scalar& w : point.weights) total += w;
    const Scalar least = *std::min_element(point.weights.begin(), point.weights.end()) / total;
    if (least > depth) depth = least, best = point;
  };
  for (const auto& polygon : subdivision.mesh.polygons) {
    if (polygon.component != sheet.component) continue;
    for (int k = 0; k < polygon.size; ++k) {
      const auto& node = subdivision.mesh.nodes[polygon.nodes[static_cast<std::size_t>(k)]];
      if (node.faces != 0) continue;
      offer(node_point(subdivision.refinement, node, level));
    }
    InnerVertex<Scalar> point;
    if (point_in_cell(subdivision.refinement, subdivision.refinement.cells()[polygon.cell], level,
                      point))
      offer(point);
  }
  if (!(depth > Scalar(0))) return false;
  const auto centre = -1 - static_cast<std::int32_t>(out.inner.size());
  out.inner.push_back(best);
  const auto boundary =
      loop_vertices(proved.loops[static_cast<std::size_t>(sheet.loops[0])], vertices);
  for (std::size_t i = 0; i < boundary.size(); ++i)
    out.triangles.push_back({boundary[i].id, boundary[(i + 1) % boundary.size()].id, centre});
  return boundary.size() > 2;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                         \
  template bool mesh_as_fan(const CellTopology<Scalar>&, const SheetTopology&, \
                            const FaceArcVertices&, const Level<Scalar>&, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
