// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/edge_flips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/tet_geometry.hpp"
#include "extract/patch/level_in_double.hpp"
#include "extract/patch/linked_triangles.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// A flip for distance makes the squares so much smaller, at no more than half of the angles; one
/// for angles makes their least sine so much larger.
constexpr double kCloser = 0.9, kAnglesKept = 0.5, kWider = 1.01;

/// Triangles go on facing larger modes: cosine of their normal and the gradient.
constexpr double kLeastCosine = 0.1;

/// Edges, some of which go while others come.
class EdgeSet {
 public:
  using Edge = std::uint64_t;  ///< smaller vertex first

  /// @param edges ascending
  void start(std::vector<Edge> edges) {
    first_ = std::move(edges);
    is_there_.assign(first_.size(), 1);
  }
  bool contains(Edge edge) const {
    const auto place = place_of(edge);
    return place < first_.size() ? is_there_[place] != 0 : others_.contains(edge);
  }
  void insert(Edge edge) { set(edge, true); }
  void erase(Edge edge) { set(edge, false); }

 private:
  std::size_t place_of(Edge edge) const {
    const auto found = std::lower_bound(first_.begin(), first_.end(), edge);
    return found != first_.end() && *found == edge
               ? static_cast<std::size_t>(found - first_.begin())
               : first_.size();
  }

  void set(Edge edge, bool is_there) {
    if (const auto place = place_of(edge); place < first_.size())
      is_there_[place] = is_there;
    else if (is_there)
      others_.insert(edge);
    else
      others_.erase(edge);
  }

  std::vector<Edge> first_;
  std::vector<char> is_there_;  ///< of the first
  std::unordered_set<Edge> others_;
};

/// Triangles of one tetrahedron, between places in a list of vertices.
class Flips {
 public:
  using Triangle = LinkedTriangles::Triangle;
  static constexpr std::uint32_t kNone = LinkedTriangles::kNone;

  Flips(const TetGeometry& geometry, const std::array<Deviator<double>, 4>& tensors,
        const Level<double>& level, Folded folded, std::vector<Triangle> triangles)
      : geometry_(geometry),
        tensors_(tensors),
        level_(level),
        folded_(folded),
        triangles_(std::move(triangles)) {}

  std::vector<Vector3<double>> points;
  std::vector<std::uint8_t> faces;  ///< of the tetrahedron, that hold the vertices

  const LinkedTriangles& triangles() const { return triangles_; }

  std::size_t run() {
    start_edges();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      std::array<double, 3> offsets;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t u = triangles_.across(t, k);
        const std::uint32_t next = triangles_[t][(k + 1) % 3];
        offsets[k] = u < t ? shapes_[u].offsets[triangles_.corner_of(u, next)]
                           : middle_of(triangles_[t][k], next).offset;
      }
      shapes_.push_back(shape_of(triangles_[t], offsets));
    }
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (t < triangles_.across(t, k)) edges.push_back({t, k});
    std::size_t flipped = 0;
    // Ends by itself: squares never grow, and angles do where these stay. This is for rounding.
    const std::size_t most = 4 * triangles_.size();
    for (std::size_t next = 0; next < edges.size() && flipped < most; ++next) {
      const auto [t, k] = edges[next];
      const std::uint32_t u = triangles_.across(t, k);
      if (u == kNone || !flip(t, k)) continue;
      ++flipped;
      for (const std::uint32_t v : {t, u})
        for (std::uint32_t i = 0; i < 3; ++i)
          if (triangles_.across(v, i) != kNone && triangles_.across(v, i) != t &&
              triangles_.across(v, i) != u)
            edges.push_back({v, i});
    }
    return flipped;
  }

 private:
  struct Shape {
    std::array<double, 3> offsets;  ///< from the level at the middles of the edges, in order
    double squares;                 ///< of the triangle's distances, by area
    double least_sine;              ///< of the least angle, which is at most 60 degrees
  };

  /// The level beside the middle of an edge.
  struct Middle {
    double offset;  ///< towards larger modes
    Vector3<double> up;
  };

  void start_edges() {
    std::vector<EdgeSet::Edge> edges;
    edges.reserve(2 * triangles_.size() + 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (t < triangles_.across(t, k))  // each once; nothing across is a large number
          edges.push_back(key(triangles_[t][k], triangles_[t][(k + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    edges_.start(std::move(edges));
  }

  Middle middle_of(std::uint32_t a, std::uint32_t b) const {
    const auto at = level_slope(geometry_.tensor(0.5 * (points[a] + points[b]), tensors_), level_);
    const auto g = geometry_.gradient(at.slope, tensors_);
    const double length = std::sqrt(dot(g, g));
    return {at.value / length, (1 / length) * g};
  }

  Vector3<double> normal(const Triangle& t) const {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  }

  bool faces_up(const Triangle& t, const Vector3<double>& up) const {
    const auto n = normal(t);
    return dot(n, up) > kLeastCosine * length(n);
  }

  /// A quadratic offset that vanishes at the corners and has these values at the middles: the mean
  /// of its square is 8/45 of the sum of all their products.
  Shape shape_of(const Triangle& t, const std::array<double, 3>& offsets) const {
    const auto n = normal(t);
    const double twice_area = length(n);
    const auto& [a, b, c] = offsets;
    return {offsets, twice_area * (a * a + b * b + c * c + a * b + b * c + c * a),
            least_sine(points[t[0]], points[t[1]], points[t[2]], twice_area)};
  }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    return std::uint64_t{low} << 32 | high;
  }

  /// Replaces the edge of triangle t after its corner k by the other diagonal, if that is better.
  bool flip(std::uint32_t t, std::uint32_t k) {
    const auto [u, at_b, a, b, c, d] = triangles_.pair_at(t, k);
    if (c == d || (faces[c] & faces[d]) != 0) return false;
    const Triangle one{a, d, c}, two{d, b, c};
    const Middle middle = middle_of(c, d);
    if (!faces_up(one, middle.up) || !faces_up(two, middle.up)) return false;
    const auto &at_t = shapes_[t].offsets, &at_u = shapes_[u].offsets;
    const Shape p = shape_of(one, {at_u[(at_b + 1) % 3], middle.offset, at_t[(k + 2) % 3]}),
                q = shape_of(two, {at_u[(at_b + 2) % 3], at_t[(k + 1) % 3], middle.offset});
    const double squares = p.squares + q.squares, sine = std::min(p.least_sine, q.least_sine);
    const double old_squares = shapes_[t].squares + shapes_[u].squares,
                 old_sine = std::min(shapes_[t].least_sine, shapes_[u].least_sine);
    const bool is_closer = squares < kCloser * old_squares && sine > kAnglesKept * old_sine;
    const bool is_wider = squares <= old_squares && sine > kWider * old_sine;
    const bool is_unfolded = folded_ == Folded::unfolded &&
                             dot(normal(triangles_[t]), normal(triangles_[u])) <= 0 &&
                             dot(normal(one), normal(two)) > 0;
    if (!(is_closer || is_wider || is_unfolded) || edges_.contains(key(c, d))) return false;
    edges_.erase(key(a, b));
    edges_.insert(key(c, d));
    triangles_.flip(t, k);
    shapes_[t] = p;
    shapes_[u] = q;
    return true;
  }

  const TetGeometry& geometry_;
  const std::array<Deviator<double>, 4>& tensors_;
  const Level<double>& level_;
  Folded folded_;
  LinkedTriangles triangles_;
  std::vector<Shape> shapes_;
  EdgeSet edges_;
};

}  // namespace

template <class Scalar>
std::size_t flip_edges(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                       std::span<const std::vector<BoundaryVertex>> boundaries,
                       Patch<Scalar>& patch, Folded folded) {
  const double unit = unit_of(tet.points);
  auto corners = tet.points;
  for (auto& p : corners) p = unit * p;
  const TetGeometry geometry(corners, tet.simplex.exponents);
  const std::array<Deviator<double>, 4> tensors = rounded(tet.simplex.tensors);
  const auto in_double = level_in_double(level);

  std::vector<std::int32_t> ids;
  for (const auto& t : patch.triangles) ids.insert(ids.end(), t.begin(), t.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto place = [&](std::int32_t id) {
    return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
  std::vector<Flips::Triangle> triangles;
  triangles.reserve(patch.triangles.size());
  for (const auto& t : patch.triangles)
    triangles.push_back({place(t[0]), place(t[1]), place(t[2])});
  Flips flips(geometry, tensors, in_double, folded, std::move(triangles));
  flips.points.resize(ids.size());
  flips.faces.resize(ids.size(), 0);
  for (std::size_t i = 0; i < ids.size() && ids[i] < 0; ++i)
    flips.points[i] = position_at(patch.inner[static_cast<std::size_t>(-1 - ids[i])].weights,
                                  tet.simplex.exponents, corners);
  for (const auto& boundary : boundaries)
    for (const auto& vertex : boundary) {
      flips.points[place(vertex.id)] = unit * vertex.position;
      flips.faces[place(vertex.id)] = vertex.faces;
    }
  const std::size_t count = flips.run();
  if (count > 0)
    for (std::size_t i = 0; i < patch.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) patch.triangles[i][k] = ids[flips.triangles()[i][k]];
  return count;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                          \
  template std::size_t flip_edges(const TetWithCurves<Scalar>&, const Level<Scalar>&,           \
                                  std::span<const std::vector<BoundaryVertex>>, Patch<Scalar>&, \
                                  Folded);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
