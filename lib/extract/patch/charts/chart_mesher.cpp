// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/chart_mesher.hpp"

#include <algorithm>
#include <map>

#include "extract/level/position.hpp"
#include "extract/patch/charts/defect_cuts.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/patch/quality/split_triangles.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// Vertices at defects: at most so many, and twice as many as there are others.
constexpr std::size_t kMostAdded = 200;

}  // namespace

template <class Scalar>
ChartMesher<Scalar>::ChartMesher(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                                 const CellTopology<Scalar>& proved,
                                 const FaceArcVertices& vertices, const Level<Scalar>& level,
                                 int defect_rounds, Patch<Scalar>& out)
    : tet_(tet),
      proved_(proved),
      level_(level),
      defect_rounds_(defect_rounds),
      out_(out),
      inner_(manifold, tet, level, out) {
  for (const auto& loop : proved.loops) {
    boundaries_.push_back(loop_vertices(loop, vertices));
    for (const auto& vertex : boundaries_.back()) inner_.take(vertex.position);
  }
}

template <class Scalar>
std::span<const Vector3<double>> ChartMesher<Scalar>::places_in_space() {
  std::map<std::int32_t, Vector3<double>> of_boundary;
  if (places_in_space_.empty())
    for (const auto& boundary : boundaries_)
      for (const auto& vertex : boundary) of_boundary[vertex.id] = vertex.position;
  for (std::size_t i = places_in_space_.size(); i < images_.size(); ++i) {
    const auto corner = images_[i].corner;
    places_in_space_.push_back(
        corner >= 0 ? of_boundary.at(corner)
                    : position_at(out_.inner[static_cast<std::size_t>(-1 - corner)].weights,
                                  tet_.simplex.exponents, tet_.points));
  }
  return places_in_space_;
}

template <class Scalar>
bool ChartMesher<Scalar>::triangulate() {
  ChartTriangulation triangulation;
  const auto points = points_;  // images are added
  DefectCuts cuts(tet_);
  const auto judge = [&](const auto& triangles) {
    return cuts(triangles, places_in_space(), segments_);
  };
  std::size_t room = kMostAdded;
  const auto add = [&](const ChartTriangulation::Place& place) {
    if (room == 0) return std::optional<ChartTriangulation::Point>();
    --room;
    Vector3<double> v{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) v += place.weights[i] * images_[place.corners[i]].v;
    const auto image = add_inner_image(v);
    return image ? std::optional(points_[*image]) : std::nullopt;
  };
  if (!triangulation.build(
          points, segments_,
          [&](const auto& clearance) {
            auto samples = grid_samples(clearance);
            room += 2 * images_.size();
            return samples;
          },
          judge, add, defect_rounds_))
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
  if (defect_rounds_ > 0)
    drop_unused_inner(out_);
  else
    flip_edges<Scalar>(tet_, level_, boundaries_, out_);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class ChartMesher<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
