// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/bisected_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/position.hpp"
#include "extract/level/tet_geometry.hpp"
#include "extract/patch/fill/polygon.hpp"
#include "extract/patch/fill/turned_loop.hpp"
#include "extract/patch/level_in_double.hpp"
#include "extract/patch/linked_triangles.hpp"
#include "extract/patch/patch_defects.hpp"
#include "extract/patch/vertex_on_level.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

/// Longer boundary loops, and sheets that need more vertices inside, are left to other meshers.
constexpr std::size_t kLongestLoop = 64, kMostInside = 256;

/// How often all edges are looked at.
constexpr int kRounds = 12;

/// Triangles against the gradient that a sheet may have on the way: more are hardly ever turned
/// back.
constexpr int kMostAgainst = 3;

/// What a right angle between medium eigenvectors counts as in cutting a polygon, in its size: two
/// places that are far apart on a bent sheet may be close in space, but not if this is large.
constexpr double kRightAngle = 10;

/// The least cosine of a tube's dominant eigenvectors and their mean: the frame across this tells
/// how far the medium eigenvectors are turned.
constexpr double kLeastCosineOfTube = 0.5;

/// A frame across the mean of the dominant eigenvectors of a tube, if these turn little.
std::optional<EigenvectorFrame> frame_of_tube(std::span<const BoundaryVertex> boundary) {
  const Vector3<double>& one = boundary[0].dominant;
  Vector3<double> sum{};
  for (const auto& v : boundary) sum += (dot(v.dominant, one) < 0 ? -1.0 : 1.0) * v.dominant;
  if (!(dot(sum, sum) > 0)) return std::nullopt;
  const auto mean = unit(sum);
  if (!std::all_of(boundary.begin(), boundary.end(), [&](const BoundaryVertex& v) {
        return std::abs(dot(v.dominant, mean)) > kLeastCosineOfTube;
      }))
    return std::nullopt;
  return frame_across(mean);
}

/// In a unit in which products of lengths do not overflow.
std::array<Vector3<double>, 4> in_unit(std::array<Vector3<double>, 4> points) {
  const double unit = unit_of(points);
  for (auto& p : points) p = unit * p;
  return points;
}

template <class Scalar>
class BisectedPatch {
 public:
  BisectedPatch(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                const Sampling& sampling, std::span<const BoundaryVertex> boundary,
                std::vector<LinkedTriangles::Triangle> triangles, Patch<Scalar>& out)
      : tet_(tet),
        level_(level),
        places_(in_unit(tet.points)),
        geometry_(places_, tet.simplex.exponents),
        tensors_(rounded(tet.simplex.tensors)),
        level_in_double_(level_in_double(level)),
        upward_(places_, tet.simplex.exponents, tensors_),
        flatness_(sampling.largest_turn() / 8),
        turn_(elementary::cos(std::min(sampling.largest_turn(), 1.5))),
        wide_turn_(elementary::cos(std::min(2 * sampling.largest_turn(), 1.5))),
        is_near_degenerate_(is_near_degenerate(level)),
        corners_(boundary.begin(), boundary.end()),
        triangles_(std::move(triangles)),
        out_(out) {
    const double unit = unit_of(tet.points);
    for (auto& corner : corners_) corner.position = unit * corner.position;
  }

  bool mesh() {
    const std::size_t first = corners_.size();
    for (int round = 0; round < kRounds; ++round) {
      if (is_folded()) return false;
      if (!bisect_edges()) break;
      if (corners_.size() > first + kMostInside) return false;
      flip_edges();
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      out_.triangles.push_back({corners_[a].id, corners_[b].id, corners_[c].id});
    }
    return true;
  }

 private:
  struct Edge {
    double length;
    std::uint32_t triangle, corner;
  };

  bool turns_far(const BoundaryVertex& a, const BoundaryVertex& b) const {
    return !(line_cosine(a.medium, b.medium) > turn_) ||
           !(line_cosine(a.dominant, b.dominant) > wide_turn_);
  }

  bool sags(const Vector3<double>& a, const Vector3<double>& b) const {
    const double sag = detail::sag_of_chord(geometry_.tensor(a, tensors_),
                                            geometry_.tensor(b, tensors_), level_.sign);
    return detail::sag_halvings(sag) > 0;
  }

  /// Whether the level is farther than a distance, to first order.
  bool is_off_level(const Vector3<double>& x, double distance) const {
    const auto at = level_slope(geometry_.tensor(x, tensors_), level_in_double_);
    const auto g = geometry_.gradient(at.slope, tensors_);
    return !(std::abs(at.value) <= distance * std::sqrt(dot(g, g)));
  }

  /// Whether more triangles than `kMostAgainst` lie against the gradient.
  bool is_folded() const {
    int against = 0;
    for (std::uint32_t t = 0; t < triangles_.size() && against <= kMostAgainst; ++t) {
      const auto& [a, b, c] = triangles_[t];
      against += !upward_.facing(at(a), at(b), at(c)).is_upward;
    }
    return against > kMostAgainst;
  }

  /// Bisects edges, at most one of each triangle.
  /// @return whether there were any
  bool bisect_edges() {
    std::vector<Edge> far;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t u = triangles_.across(t, k);
        if (u == LinkedTriangles::kNone || u < t) continue;
        const auto &a = corners_[triangles_[t][k]], &b = corners_[triangles_[t][(k + 1) % 3]];
        const double size = length(b.position - a.position);
        if ((turns_far(a, b) && is_off_level(0.5 * (a.position + b.position), flatness_ * size)) ||
            (is_near_degenerate_ && sags(a.position, b.position)))
          far.push_back({size, t, k});
      }
    std::stable_sort(far.begin(), far.end(),
                     [](const Edge& p, const Edge& q) { return p.length > q.length; });
    std::vector<char> is_cut(triangles_.size(), 0);
    bool any = false;
    for (const Edge& edge : far) {
      const std::uint32_t t = edge.triangle, u = triangles_.across(t, edge.corner);
      if (is_cut[t] || u >= is_cut.size() || is_cut[u]) continue;  // or new
      is_cut[t] = is_cut[u] = 1;
      if (!add_middle(triangles_[t][edge.corner], triangles_[t][(edge.corner + 1) % 3])) continue;
      triangles_.bisect(t, edge.corner, static_cast<LinkedTriangles::Vertex>(corners_.size() - 1));
      any = true;
    }
    return any;
  }

  /// A vertex on the level beside the middle of an edge; false if none is found.
  bool add_middle(LinkedTriangles::Vertex a, LinkedTriangles::Vertex b) {
    const auto middle = 0.5 * (corners_[a].position + corners_[b].position);
    const auto& exponents = tet_.simplex.exponents;
    const int least = *std::min_element(exponents.begin(), exponents.end());
    std::array<Scalar, 4> weights;
    Scalar total(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const double w = geometry_.weight(i, middle);
      if (!(w > 0)) return false;
      weights[i] = Scalar(times_power(w, least - exponents[i]));
      total += weights[i];
    }
    for (auto& w : weights) w = w / total;
    const auto vertex = vertex_on_far_level(tet_, level_, weights);
    if (!vertex) return false;
    const auto at = position_at(vertex->weights, exponents, places_);
    if (std::any_of(corners_.begin(), corners_.end(),
                    [&](const BoundaryVertex& other) { return other.position == at; }))
      return false;
    out_.inner.push_back(*vertex);
    corners_.push_back({-static_cast<std::int32_t>(out_.inner.size()), 0, at,
                        vector_cast<double>(medium_eigenvector(vertex->tensor, level_)),
                        vector_cast<double>(dominant_eigenvector(vertex->tensor, level_))});
    return true;
  }

  Vector3<double> at(LinkedTriangles::Vertex v) const { return corners_[v].position; }

  Vector3<double> normal(LinkedTriangles::Vertex a, LinkedTriangles::Vertex b,
                         LinkedTriangles::Vertex c) const {
    return cross(at(b) - at(a), at(c) - at(a));
  }

  /// The cotangent of a triangle's angle at its first corner.
  double cotangent(LinkedTriangles::Vertex a, LinkedTriangles::Vertex b,
                   LinkedTriangles::Vertex c) const {
    const auto p = at(b) - at(a), q = at(c) - at(a);
    const auto n = cross(p, q);
    return dot(p, q) / length(n);
  }

  /// Whether the angles opposite an edge have a sum of more than 180 degrees, and the other
  /// diagonal does not fold the triangles.
  bool is_better_flipped(std::uint32_t t, std::uint32_t k) const {
    const auto [u, corner, a, b, c, d] = triangles_.pair_at(t, k);
    if ((corners_[c].faces & corners_[d].faces) != 0) return false;
    if (!(cotangent(c, a, b) + cotangent(d, b, a) < 0)) return false;
    const auto both = normal(a, b, c) + normal(b, a, d);
    return dot(normal(a, d, c), both) > 0 && dot(normal(d, b, c), both) > 0 &&
           !triangles_.has_edge(c, d);
  }

  void flip_edges() {
    // Ends by itself but for rounding.
    std::size_t left = 4 * triangles_.size();
    for (bool any = true; any && left > 0;) {
      any = false;
      for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (std::uint32_t k = 0; k < 3 && left > 0; ++k) {
          const std::uint32_t u = triangles_.across(t, k);
          if (u == LinkedTriangles::kNone || u < t || !is_better_flipped(t, k)) continue;
          triangles_.flip(t, k);
          any = true, --left;
        }
    }
  }

  const TetWithCurves<Scalar>& tet_;
  const Level<Scalar>& level_;
  std::array<Vector3<double>, 4> places_;  ///< of the tetrahedron's vertices, as all positions here
  TetGeometry geometry_;
  std::array<Deviator<double>, 4> tensors_;
  Level<double> level_in_double_;
  UpwardTest upward_;
  double flatness_;          ///< distance of the level from the middle of an edge, over its length
  double turn_, wide_turn_;  ///< cosines
  bool is_near_degenerate_;
  std::vector<BoundaryVertex> corners_;
  LinkedTriangles triangles_;
  Patch<Scalar>& out_;
};

}  // namespace

template <class Scalar>
bool mesh_bisected_disc(const TetWithCurves<Scalar>& tet, std::span<const BoundaryVertex> boundary,
                        const Level<Scalar>& level, const Sampling& sampling, Patch<Scalar>& out) {
  if (boundary.size() > kLongestLoop) return false;
  std::vector<PolygonCorner> polygon;
  polygon.reserve(boundary.size());
  double size = 0;
  for (const auto& v : boundary) size = std::max(size, length(v.position - boundary[0].position));
  const double weight = std::sqrt(kRightAngle * size);
  for (const auto& v : boundary) polygon.push_back({v.position, v.faces, weight * v.medium});
  std::vector<LinkedTriangles::Triangle> triangles;
  for (const auto& [a, b, c] : cut_polygon(polygon))
    triangles.push_back({static_cast<LinkedTriangles::Vertex>(a),
                         static_cast<LinkedTriangles::Vertex>(b),
                         static_cast<LinkedTriangles::Vertex>(c)});
  if (triangles.empty()) return false;
  return BisectedPatch<Scalar>(tet, level, sampling, boundary, std::move(triangles), out).mesh();
}

template <class Scalar>
bool mesh_bisected_tube(const TetWithCurves<Scalar>& tet, std::span<const BoundaryVertex> first,
                        std::span<const BoundaryVertex> last, const Level<Scalar>& level,
                        const Sampling& sampling, Patch<Scalar>& out) {
  if (first.size() > kLongestLoop || last.size() > kLongestLoop) return false;
  std::vector<BoundaryVertex> corners(first.begin(), first.end());
  // Boundary loops have the sheet on their left: seen along the tube they run opposite ways.
  corners.insert(corners.end(), last.rbegin(), last.rend());
  const auto frame = frame_of_tube(corners);
  if (!frame) return false;
  const std::span<const BoundaryVertex> all(corners);
  auto lower = turned_loop(all.first(first.size()), *frame),
       upper = turned_loop(all.subspan(first.size()), *frame);
  if (!lower || !upper || lower->is_clockwise != upper->is_clockwise) return false;
  std::iota(lower->loop.corners.begin(), lower->loop.corners.end(), 0);
  std::iota(upper->loop.corners.begin(), upper->loop.corners.end(),
            static_cast<std::int32_t>(first.size()));
  std::vector<std::array<std::int32_t, 3>> strip;
  join_loops(lower->loop, upper->loop, strip);
  std::vector<LinkedTriangles::Triangle> triangles;
  for (const auto& t : strip) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(t[i]), b = static_cast<std::size_t>(t[(i + 1) % 3]);
      const bool is_across = (a < first.size()) != (b < first.size());
      if (is_across && (corners[a].faces & corners[b].faces) != 0) return false;
    }
    triangles.push_back({static_cast<LinkedTriangles::Vertex>(t[0]),
                         static_cast<LinkedTriangles::Vertex>(t[1]),
                         static_cast<LinkedTriangles::Vertex>(t[2])});
  }
  return BisectedPatch<Scalar>(tet, level, sampling, corners, std::move(triangles), out).mesh();
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template bool mesh_bisected_disc(const TetWithCurves<Scalar>&, std::span<const BoundaryVertex>, \
                                   const Level<Scalar>&, const Sampling&, Patch<Scalar>&);        \
  template bool mesh_bisected_tube(const TetWithCurves<Scalar>&, std::span<const BoundaryVertex>, \
                                   std::span<const BoundaryVertex>, const Level<Scalar>&,         \
                                   const Sampling&, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
