// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/edge_flips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

#include "extract/level/position.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/tet_geometry.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// A flip for distance makes the squares so much smaller, at no more than half of the angles; one
/// for angles makes their least sine so much larger.
constexpr double kCloser = 0.9, kAnglesKept = 0.5, kWider = 1.01;

/// Triangles go on facing larger modes: cosine of their normal and the gradient.
constexpr double kLeastCosine = 0.1;

/// What `level_slope` needs.
template <class Scalar>
Level<double> in_double(const Level<Scalar>& level) {
  Level<double> result;
  result.mu = static_cast<double>(level.mu);
  result.sqrt2 = static_cast<double>(level.sqrt2);
  return result;
}

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
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Flips(const TetGeometry& geometry, const std::array<Deviator<double>, 4>& tensors,
        const Level<double>& level, Folded folded)
      : geometry_(geometry), tensors_(tensors), level_(level), folded_(folded) {}

  std::vector<Vector3<double>> points;
  std::vector<std::uint8_t> faces;  ///< of the tetrahedron, that hold the vertices
  std::vector<Triangle> triangles;

  std::size_t run() {
    find_neighbours();
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      std::array<double, 3> offsets;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t u = across_[t][k];
        offsets[k] = u < t ? shapes_[u].offsets[corner_of(triangles[u], triangles[t][(k + 1) % 3])]
                           : middle_of(triangles[t][k], triangles[t][(k + 1) % 3]).offset;
      }
      shapes_.push_back(shape_of(triangles[t], offsets));
    }
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (t < across_[t][k]) edges.push_back({t, k});
    std::size_t flipped = 0;
    // Ends by itself: squares never grow, and angles do where these stay. This is for rounding.
    const std::size_t most = 4 * triangles.size();
    for (std::size_t next = 0; next < edges.size() && flipped < most; ++next) {
      const auto [t, k] = edges[next];
      const std::uint32_t u = across_[t][k];
      if (u == kNone || !flip(t, k)) continue;
      ++flipped;
      for (const std::uint32_t v : {t, u})
        for (std::uint32_t i = 0; i < 3; ++i)
          if (across_[v][i] != kNone && across_[v][i] != t && across_[v][i] != u)
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

  /// across_[t][k]: the triangle across the edge from corner k to the next.
  void find_neighbours() {
    struct Side {
      std::uint64_t edge;  ///< smaller vertex first
      std::uint32_t triangle, corner;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        sides.push_back({key(triangles[t][k], triangles[t][(k + 1) % 3]), t, k});
    std::sort(sides.begin(), sides.end(),
              [](const Side& p, const Side& q) { return p.edge < q.edge; });
    std::vector<EdgeSet::Edge> edges;
    edges.reserve(sides.size());
    for (const Side& side : sides)
      if (edges.empty() || edges.back() != side.edge) edges.push_back(side.edge);
    edges_.start(std::move(edges));
    across_.assign(triangles.size(), {kNone, kNone, kNone});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
      if (sides[i].edge == sides[i + 1].edge) {
        across_[sides[i].triangle][sides[i].corner] = sides[i + 1].triangle;
        across_[sides[i + 1].triangle][sides[i + 1].corner] = sides[i].triangle;
      }
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

  static std::uint32_t corner_of(const Triangle& t, std::uint32_t v) {
    return static_cast<std::uint32_t>(std::find(t.begin(), t.end(), v) - t.begin());
  }

  void set_across(std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    if (t != kNone) *std::find(across_[t].begin(), across_[t].end(), from) = to;
  }

  /// Replaces the edge of triangle t after its corner k by the other diagonal, if that is better.
  bool flip(std::uint32_t t, std::uint32_t k) {
    const std::uint32_t u = across_[t][k];
    const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3],
                        c = triangles[t][(k + 2) % 3];
    const std::uint32_t at_b = corner_of(triangles[u], b);
    const std::uint32_t d = triangles[u][(at_b + 2) % 3];
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
                             dot(normal(triangles[t]), normal(triangles[u])) <= 0 &&
                             dot(normal(one), normal(two)) > 0;
    if (!(is_closer || is_wider || is_unfolded) || edges_.contains(key(c, d))) return false;
    edges_.erase(key(a, b));
    edges_.insert(key(c, d));
    const std::uint32_t bc = across_[t][(k + 1) % 3], ca = across_[t][(k + 2) % 3],
                        ad = across_[u][(at_b + 1) % 3], db = across_[u][(at_b + 2) % 3];
    triangles[t] = one;
    triangles[u] = two;
    across_[t] = {ad, u, ca};
    across_[u] = {db, bc, t};
    set_across(ad, u, t);
    set_across(bc, t, u);
    shapes_[t] = p;
    shapes_[u] = q;
    return true;
  }

  const TetGeometry& geometry_;
  const std::array<Deviator<double>, 4>& tensors_;
  const Level<double>& level_;
  Folded folded_;
  std::vector<std::array<std::uint32_t, 3>> across_;
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
  const auto level_in_double = in_double(level);
  Flips flips(geometry, tensors, level_in_double, folded);

  std::vector<std::int32_t> ids;
  for (const auto& t : patch.triangles) ids.insert(ids.end(), t.begin(), t.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto place = [&](std::int32_t id) {
    return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
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
  flips.triangles.reserve(patch.triangles.size());
  for (const auto& t : patch.triangles)
    flips.triangles.push_back({place(t[0]), place(t[1]), place(t[2])});
  const std::size_t count = flips.run();
  if (count > 0)
    for (std::size_t i = 0; i < patch.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) patch.triangles[i][k] = ids[flips.triangles[i][k]];
  return count;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                          \
  template std::size_t flip_edges(const TetWithCurves<Scalar>&, const Level<Scalar>&,           \
                                  std::span<const std::vector<BoundaryVertex>>, Patch<Scalar>&, \
                                  Folded);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
