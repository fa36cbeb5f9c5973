// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/graph_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/patch/charts/chart_triangulation.hpp"
#include "extract/patch/charts/defect_cuts.hpp"
#include "extract/patch/charts/line_view.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

constexpr int kGraphRounds = 16;

/// Meshes the sheets of one tetrahedron as graphs.
template <class Scalar>
class GraphMesher {
 public:
  GraphMesher(const TetWithCurves<Scalar>& tet, const LineView<Scalar>& view,
              const CellTopology<Scalar>& proved, const Level<Scalar>& level,
              const Sampling& sampling, int defect_rounds, Patch<Scalar>& out)
      : tet_(tet),
        view_(view),
        proved_(proved),
        level_(level),
        defect_rounds_(defect_rounds),
        turn_(elementary::cos(std::min(sampling.largest_turn(), 1.5))),
        wide_turn_(elementary::cos(std::min(2 * sampling.largest_turn(), 1.5))),
        out_(out) {}

  bool mesh(const FaceArcVertices& vertices) {
    for (const auto& loop : proved_.loops) add_loop(loop_vertices(loop, vertices));
    const BoundaryEdges boundary(boundaries_);
    ChartTriangulation triangulation;
    const auto points = points_;  // `add` makes more
    DefectCuts at_defects(tet_);
    const auto judge = [&](const auto& triangles) {
      std::vector<Cut> cuts;
      cuts.reserve(triangles.size());
      for (const auto& t : triangles) cuts.push_back(cut(t, boundary));
      // Only where nothing else is to be done.
      if (defect_rounds_ > 0 &&
          std::all_of(cuts.begin(), cuts.end(), [](Cut c) { return c == Cut::none; }))
        return at_defects(triangles, places_in_space_, segments_);
      return cuts;
    };
    if (!triangulation.build(
            points, segments_, [](const auto&) { return std::vector<ChartTriangulation::Point>(); },
            judge, [&](const auto& place) { return add(place); }, kGraphRounds + defect_rounds_))
      return false;
    return emit(triangulation.triangles);
  }

 private:
  using Cut = ChartTriangulation::Cut;

  struct Corner {
    std::int32_t id;
    std::uint8_t faces;
    typename LineView<Scalar>::Weights mapped;
    Vector3<double> medium, dominant;
  };

  void add_loop(std::vector<BoundaryVertex> boundary) {
    const std::size_t first = corners_.size(), n = boundary.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto& v = boundary[i];
      const auto mapped = view_.mapped(v.position);
      corners_.push_back({v.id, v.faces, mapped, v.medium, v.dominant});
      points_.push_back(view_.seen(mapped));
      places_in_space_.push_back(v.position);
      taken_.insert({v.position.x, v.position.y, v.position.z});
      segments_.push_back({first + i, first + (i + 1) % n});
    }
    boundaries_.push_back(std::move(boundary));
  }

  bool turns_far(const Corner& a, const Corner& b) const {
    return !(line_cosine(a.medium, b.medium) > turn_) ||
           !(line_cosine(a.dominant, b.dominant) > wide_turn_);
  }

  Cut cut(const std::array<std::size_t, 3>& t, const BoundaryEdges& boundary) const {
    const Corner* c[3] = {&corners_[t[0]], &corners_[t[1]], &corners_[t[2]]};
    // A diagonal between two boundary loop vertices on one face might be chosen by the neighbour as
    // well.
    constexpr Cut edges[3] = {Cut::edge0, Cut::edge1, Cut::edge2};
    bool far = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &a = *c[(i + 1) % 3], &b = *c[(i + 2) % 3];
      if ((a.faces & b.faces) == 0)
        far |= turns_far(a, b);
      else if (!boundary.joins(a.id, b.id))
        return edges[i];
    }
    // A boundary loop of three vertices on one face would leave a triangle in that face.
    if ((c[0]->faces & c[1]->faces & c[2]->faces) != 0) return Cut::amid;
    return far ? Cut::amid : Cut::none;
  }

  std::optional<ChartTriangulation::Point> add(const ChartTriangulation::Place& place) {
    typename LineView<Scalar>::Weights mapped{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 4; ++i)
        mapped[i] += place.weights[c] * corners_[place.corners[c]].mapped[i];
    const auto vertex = view_.on_level(mapped, level_);
    if (!vertex) return std::nullopt;
    const auto at = position_at(vertex->weights, tet_.simplex.exponents, tet_.points);
    if (!taken_.insert({at.x, at.y, at.z}).second) return std::nullopt;
    out_.inner.push_back(*vertex);
    corners_.push_back({-static_cast<std::int32_t>(out_.inner.size()), 0, view_.mapped(*vertex),
                        vector_cast<double>(medium_eigenvector(vertex->tensor, level_)),
                        vector_cast<double>(dominant_eigenvector(vertex->tensor, level_))});
    places_in_space_.push_back(at);
    return place.at;
  }

  bool emit(const std::vector<std::array<std::size_t, 3>>& triangles) {
    for (const auto& t : triangles)
      out_.triangles.push_back({corners_[t[0]].id, corners_[t[1]].id, corners_[t[2]].id});
    if (!direct_as_proved(out_.triangles, boundaries_, proved_.sheets)) return false;
    if (defect_rounds_ > 0)
      drop_unused_inner(out_);
    else
      flip_edges<Scalar>(tet_, level_, boundaries_, out_);
    return true;
  }

  const TetWithCurves<Scalar>& tet_;
  const LineView<Scalar>& view_;
  const CellTopology<Scalar>& proved_;
  const Level<Scalar>& level_;
  int defect_rounds_;
  double turn_, wide_turn_;  ///< cosines
  Patch<Scalar>& out_;

  std::vector<Corner> corners_;
  std::vector<ChartTriangulation::Point> points_;
  std::vector<Vector3<double>> places_in_space_;  ///< of the corners
  std::set<std::array<double, 3>> taken_;         ///< the same, to keep them distinct
  std::vector<std::array<std::size_t, 2>> segments_;
  std::vector<std::vector<BoundaryVertex>> boundaries_;
};

}  // namespace

template <class Scalar>
bool mesh_as_graph(const TetWithCurves<Scalar>& tet, const CellTopology<Scalar>& proved,
                   const FaceArcVertices& vertices, const Level<Scalar>& level,
                   const Sampling& sampling, int defect_rounds, Patch<Scalar>& out) {
  if (!proved.direction) return false;
  const auto view = LineView<Scalar>::along(tet, *proved.direction);
  if (!view) return false;
  Patch<Scalar> patch;
  if (!GraphMesher<Scalar>(tet, *view, proved, level, sampling, defect_rounds, patch)
           .mesh(vertices))
    return false;
  out = std::move(patch);
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template bool mesh_as_graph(const TetWithCurves<Scalar>&, const CellTopology<Scalar>&,          \
                              const FaceArcVertices&, const Level<Scalar>&, const Sampling&, int, \
                              Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
