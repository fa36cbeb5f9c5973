// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chart_mesher.hpp"

#include <algorithm>
#include <map>

#include "extract/patch/patch_check.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/patch/quality/split_triangles.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
ChartMesher<Scalar>::ChartMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                                 const CellTopology<Scalar>& proved,
                                 const FaceArcVertices& vertices, const Level<Scalar>& level,
                                 Patch<Scalar>& out)
    : tet_(tet), proved_(proved), level_(level), out_(out), inner_(manifold, tet, level, out) {
  for (const auto& loop : proved.loops) {
    boundaries_.push_back(loop_vertices(loop, vertices));
    for (const auto& vertex : boundaries_.back()) inner_.take(vertex.position);
  }
}

template <class Scalar>
bool ChartMesher<Scalar>::triangulate() {
  ChartTriangulation triangulation;
  const auto points = points_;  // `grid_samples` adds to the images
  if (!triangulation.build(points, segments_,
                           [&](const auto& clearance) { return grid_samples(clearance); }))
    return false;
  triangles_ = std::move(triangulation.triangles);
  return true;
}

template <class Scalar>
bool ChartMesher<Scalar>::split_diagonals() {
  const BoundaryEdges boundary(boundaries_);
  std::map<UndirectedEdge, std::vector<std::size_t>> apexes;  // of the diagonals
  for (const auto& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      const auto &p = images_[a], &q = images_[b];
      if ((p.faces & q.faces) == 0) continue;
      if (boundary.joins(p.corner, q.corner)) continue;
      apexes[std::minmax(a, b)].push_back(t[(i + 2) % 3]);
    }
  std::map<UndirectedEdge, std::size_t> middle;
  for (const auto& [e, tips] : apexes) {
    std::optional<std::size_t> image;
    for (const double lean : {0.0, 0.2, 0.5, 0.8, 2.0, 5.0})
      for (const auto tip : tips)
        if (!image)
          image = add_inner_image(images_[e.first].v + images_[e.second].v + lean * images_[tip].v);
    if (!image) return false;
    middle[e] = *image;
  }
  triangles_ = split_triangles(triangles_, middle);
  return true;
}

template <class Scalar>
bool ChartMesher<Scalar>::raise_flat_triangles() {
  const std::size_t count = triangles_.size();
  for (std::size_t t = 0; t < count; ++t) {
    const auto [a, b, c] = triangles_[t];
    const auto &p = images_[a], &q = images_[b], &r = images_[c];
    if ((p.faces & q.faces & r.faces) == 0) continue;
    std::optional<std::size_t> image;
    for (const double lean : {1.0, 0.5, 0.2})
      for (int turn = 0; turn < 3; ++turn)
        if (!image)
          image = add_inner_image((turn == 0 ? 1 : lean) * p.v + (turn == 1 ? 1 : lean) * q.v +
                                  (turn == 2 ? 1 : lean) * r.v);
    if (!image) return false;
    triangles_[t][2] = *image;
    triangles_.push_back({b, c, *image});
    triangles_.push_back({c, a, *image});
  }
  return true;
}

template <class Scalar>
bool ChartMesher<Scalar>::emit() {
  for (const auto& t : triangles_)
    out_.triangles.push_back({images_[t[0]].corner, images_[t[1]].corner, images_[t[2]].corner});
  if (!direct_as_proved(out_.triangles, boundaries_, proved_.sheets)) return false;
  flip_edges<Scalar>(tet_, level_, boundaries_, out_);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class ChartMesher<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
