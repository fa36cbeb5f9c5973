// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_drawing.hpp"

#include <algorithm>
#include <map>

#include "edge_flips.hpp"
#include "extractor_scalars.hpp"
#include "sheet_check.hpp"
#include "split_triangles.hpp"

namespace tensortopo {

template <class Scalar>
SheetDrawing<Scalar>::SheetDrawing(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                                   const TetPlan<Scalar>& plan, const FaceArcVertices& vertices,
                                   const Level<Scalar>& level, TetTriangles<Scalar>& out)
    : tet_(tet), plan_(plan), level_(level), out_(out), inner_(manifold, tet, level, out) {
  for (const auto& loop : plan.loops) {
    rims_.push_back(loop_vertices(loop, vertices));
    for (const auto& vertex : rims_.back()) inner_.take(vertex.position);
  }
}

template <class Scalar>
bool SheetDrawing<Scalar>::triangulate() {
  ChartTriangulation triangulation;
  const auto points = points_;  // `grid_samples` adds to the images
  if (!triangulation.build(points, segments_,
                           [&](const auto& clearance) { return grid_samples(clearance); }))
    return false;
  triangles_ = std::move(triangulation.triangles);
  return true;
}

template <class Scalar>
bool SheetDrawing<Scalar>::split_diagonals() {
  const RimEdges rim(rims_);
  std::map<UndirectedEdge, std::vector<std::size_t>> apexes;  // of the diagonals
  for (const auto& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      const auto &p = images_[a], &q = images_[b];
      if ((p.faces & q.faces) == 0) continue;
      if (rim.joins(p.corner, q.corner)) continue;
      apexes[std::minmax(a, b)].push_back(t[(i + 2) % 3]);
    }
  std::map<UndirectedEdge, std::size_t> middle;
  for (const auto& [e, tips] : apexes) {
    std::optional<std::size_t> image;
    for (const double lean : {0.0, 0.2, 0.5, 0.8, 2.0, 5.0})
      for (const auto tip : tips)
        if (!image)
          image = add_inner_image(images_[e.first].v + images_[e.second].v +
                                  lean * images_[tip].v);
    if (!image) return false;
    middle[e] = *image;
  }
  triangles_ = split_triangles(triangles_, middle);
  return true;
}

template <class Scalar>
bool SheetDrawing<Scalar>::raise_flat_triangles() {
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
bool SheetDrawing<Scalar>::emit() {
  for (const auto& t : triangles_)
    out_.triangles.push_back({images_[t[0]].corner, images_[t[1]].corner, images_[t[2]].corner});
  if (!direct_as_planned(out_.triangles, rims_, plan_.sheets)) return false;
  flip_edges<Scalar>(tet_, level_, rims_, out_);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class SheetDrawing<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
