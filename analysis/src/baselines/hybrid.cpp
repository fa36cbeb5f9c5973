// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "baselines/edge_roots.hpp"
#include "baselines/neutral_map.hpp"

namespace tensortopo::baselines {

namespace {

using Vector = Vector3<double>;

constexpr int kDeepest = 28;             // of a triangle of directions: 2^-14 of the sphere's
constexpr std::size_t kMost = 4000;      // triangles of directions for one tetrahedron
constexpr std::array<std::array<double, 2>, 10> kWhere{// of a cubic's coefficients: shares of b, c
    {{0, 0}, {1. / 3, 0}, {2. / 3, 0}, {1, 0}, {0, 1. / 3}, {1. / 3, 1. / 3}, {2. / 3, 1. / 3},
     {0, 2. / 3}, {1. / 3, 2. / 3}, {0, 1}}};

double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// One of v and -v.
bool is_turned(const Vector& v) { return v.x != 0 ? v.x < 0 : v.y != 0 ? v.y < 0 : v.z < 0; }

struct Cell {
  std::array<Vector, 3> corners;
  std::array<Cubic, 4> weights;
  int depth = 0;
};

struct Leaf {
  std::array<Vector, 3> corners;
  double sign = 1;  ///< of the weights inside
};

struct Vertex {
  Vector v;
  std::array<double, 4> weights{};
  unsigned faces = 0;  ///< those that it is on
};

struct InOrder {
  bool operator()(const Vector& p, const Vector& q) const { return comes_first(p, q); }
};

class Hybrid {
 public:
  Hybrid(const std::array<FieldPoint, 4>& corners, SurfaceMesh::Index tet, double tolerance,
         std::vector<SoupTriangle>& out)
      : corners_(corners),
        map_({corners[0].tensor, corners[1].tensor, corners[2].tensor, corners[3].tensor}),
        tet_(tet),
        out_(out) {
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        longest = std::max(longest, length(place(i) - place(j)));
    tolerance_ = tolerance * longest;
    const double volume = dot(cross(place(1) - place(0), place(2) - place(0)), place(3) - place(0));
    const auto gradient = [&](std::size_t a, std::size_t b, std::size_t c) {
      return (1 / volume) * cross(place(b) - place(a), place(c) - place(a));
    };
    gradients_ = {-gradient(1, 2, 3), gradient(0, 2, 3), -gradient(0, 1, 3), gradient(0, 1, 2)};
    for (std::size_t i = 0; i < 4; ++i) heights_[i] = 1 / length(gradients_[i]);
  }

  bool run() {
    const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    // The upper half of an octahedron.
    for (const auto& start : {std::array{x, y, z}, {-x, y, z}, {x, -y, z}, {-x, -y, z}})
      cells_.push_back({start, map_.on(start), 0});
    for (std::size_t done = 0; !cells_.empty(); ++done) {
      if (done == kMost) return false;
      const Cell cell = cells_.back();
      cells_.pop_back();
      const auto [positive, negative] = possible_signs(cell);
      if (!positive && !negative) continue;
      const double sign = positive ? 1 : -1;
      if (cell.depth == kDeepest) {
        if (positive) leaves_.push_back({cell.corners, 1});
        if (negative) leaves_.push_back({cell.corners, -1});
      } else if (positive != negative && is_flat(cell, sign)) {
        leaves_.push_back({cell.corners, sign});
      } else {
        cut(cell);
      }
    }
    for (const Leaf& leaf : leaves_) mesh(leaf);
    return true;
  }

 private:
  const Vector& place(std::size_t i) const { return corners_[i].position; }

  /// Whether the tetrahedron may be met with all weights positive, or all negative.
  static std::pair<bool, bool> possible_signs(const Cell& cell) {
    bool positive = true, negative = true;
    for (const Cubic& b : cell.weights) {
      const auto [low, high] = std::minmax_element(b.begin(), b.end());
      positive = positive && *high > 0;
      negative = negative && *low < 0;
    }
    return {positive, negative};
  }

  bool is_flat(const Cell& cell, double sign) const {
    std::array<Vector, 10> net;
    std::array<double, 10> sums;
    for (std::size_t k = 0; k < 10; ++k) {
      Vector sum{};
      sums[k] = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const double b = sign * cell.weights[i][k];
        sums[k] += b;
        sum += b * place(i);
      }
      if (!(sums[k] > 0)) return false;
      net[k] = (1 / sums[k]) * sum;
    }
    // The image is in the convex hull of the net.
    const auto normal = cross(net[3] - net[0], net[9] - net[0]);
    const double size = length(normal);
    for (const Vector& x : net)
      if (!(std::abs(dot(normal, x - net[0])) <= tolerance_ * size)) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      const Cubic& b = cell.weights[i];
      const auto [low, high] = std::minmax_element(b.begin(), b.end());
      if (*low >= 0 || *high <= 0) continue;
      for (std::size_t k = 0; k < 10; ++k) {
        const auto& [s, t] = kWhere[k];
        const double line = b[0] + s * (b[3] - b[0]) + t * (b[9] - b[0]);
        if (!(std::abs(b[k] - line) * heights_[i] <= tolerance_ * sums[k])) return false;
      }
    }
    return true;
  }

  void cut(const Cell& cell) {
    const auto& [a, b, c] = cell.corners;
    const Vector m = 0.5 * (a + b);
    middles_.insert(is_turned(m) ? -m : m);
    Cell first{{c, a, m}, {}, cell.depth + 1}, second{{b, c, m}, {}, cell.depth + 1};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto parts = halves(cell.weights[i]);
      first.weights[i] = parts[0];
      second.weights[i] = parts[1];
    }
    cells_.push_back(first);
    cells_.push_back(second);
  }

  Vertex vertex(const Vector& v, double sign) const {
    Vertex result{v, map_.weights(v), 0};
    for (double& b : result.weights) b *= sign;
    return result;
  }

  /// From a on, without b, with the corners of finer neighbours in between.
  void add_side(const Vector& a, const Vector& b, double sign, std::vector<Vertex>& polygon) const {
    const Vector m = 0.5 * (a + b);
    if (middles_.contains(is_turned(m) ? -m : m)) {
      add_side(a, m, sign, polygon);
      add_side(m, b, sign, polygon);
    } else {
      polygon.push_back(vertex(a, sign));
    }
  }

  void mesh(const Leaf& leaf) {
    std::vector<Vertex> polygon, clipped;
    for (std::size_t a = 0; a < 3; ++a)
      add_side(leaf.corners[a], leaf.corners[(a + 1) % 3], leaf.sign, polygon);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto is_inside = [&](const Vertex& p) { return p.weights[i] >= 0; };
      if (std::all_of(polygon.begin(), polygon.end(), is_inside)) continue;
      clipped.clear();
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vertex &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        if (is_inside(p)) clipped.push_back(p);
        if (is_inside(p) != is_inside(q)) clipped.push_back(crossing(p, q, i, leaf));
      }
      std::swap(polygon, clipped);
    }
    if (polygon.size() >= 3) emit(polygon, leaf.sign);
  }

  /// Where weight i vanishes between p and q.
  Vertex crossing(const Vertex& p, const Vertex& q, std::size_t i, const Leaf& leaf) const {
    // In one order whichever cell asks, and whichever of v and -v it has.
    const bool turned = is_turned(p.v + q.v);
    if (comes_first(turned ? -q.v : q.v, turned ? -p.v : p.v)) return crossing(q, p, i, leaf);
    double low = 0, high = 1, f_low = p.weights[i], f_high = q.weights[i], t = 0.5;
    for (int step = 0; step < 60 && high - low > 1e-16; ++step) {
      // False position, with the Illinois rule.
      t = low + (high - low) * (f_low / (f_low - f_high));
      if (!(t > low && t < high)) break;
      const double f = leaf.sign * map_.weights(p.v + t * (q.v - p.v))[i];
      if (f == 0) break;
      if ((f > 0) == (f_low > 0)) {
        low = t, f_low = f, f_high *= 0.5;
      } else {
        high = t, f_high = f, f_low *= 0.5;
      }
    }
    Vertex result = vertex(p.v + t * (q.v - p.v), leaf.sign);
    result.faces = 1U << i;
    const unsigned common = p.faces & q.faces;
    for (std::size_t j = 0; j < 4; ++j)
      if ((common >> j & 1U) != 0)
        if (const auto corner = on_both(result.v, i, j, leaf)) result = *corner;
    for (std::size_t j = 0; j < 4; ++j)
      if ((result.faces >> j & 1U) != 0) result.weights[j] = 0;
    return result;
  }

  /// By Newton's method: the point of weights i and j zero next to v in the plane of the cell.
  std::optional<Vertex> on_both(Vector v, std::size_t i, std::size_t j, const Leaf& leaf) const {
    const Vector d = leaf.corners[1] - leaf.corners[0], e = leaf.corners[2] - leaf.corners[0];
    const double h = 1e-3;
    const auto difference = [&](const Vector& along) {
      const auto up = map_.weights(v + h * along), down = map_.weights(v - h * along);
      return std::array{(up[i] - down[i]) / (2 * h), (up[j] - down[j]) / (2 * h)};
    };
    double moved = 0;
    for (int step = 0; step < 8; ++step) {
      const auto b = map_.weights(v);
      const auto bd = difference(d), be = difference(e);
      const double det = bd[0] * be[1] - bd[1] * be[0];
      const double s = (b[j] * be[0] - b[i] * be[1]) / det,
                   t = (b[i] * bd[1] - b[j] * bd[0]) / det;
      if (!(std::abs(s) + std::abs(t) < 1)) return std::nullopt;
      v = v + s * d + t * e;
      moved += std::abs(s) + std::abs(t);
      if (moved > 2) return std::nullopt;
      if (std::abs(s) + std::abs(t) < 1e-13) break;
    }
    Vertex result = vertex(v, leaf.sign);
    result.faces = 1U << i | 1U << j;
    return result;
  }

  Vector image(const Vertex& p) const {
    std::array<double, 4> b{};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += b[i] = std::max(p.weights[i], 0.0);
    Vector x{};
    for (std::size_t i = 0; i < 4; ++i) x += (b[i] / sum) * place(i);
    if (std::count(b.begin(), b.end(), 0.0) != 2 || p.faces == 0) return x;
    std::array<std::size_t, 2> ends{};
    for (std::size_t i = 0, n = 0; i < 4; ++i)
      if (b[i] > 0) ends[n++] = i;
    for (const Vector& root : neutral_points(corners_[ends[0]], corners_[ends[1]]))
      if (length(root - x) < 1e-6 * length(place(ends[0]) - place(ends[1]))) return root;
    return x;
  }

  void emit(const std::vector<Vertex>& polygon, double sign) {
    const std::size_t n = polygon.size();
    std::vector<Vector> places;
    Vector middle{};
    for (const Vertex& p : polygon) {
      places.push_back(image(p));
      middle += (1 / static_cast<double>(n)) * p.v;
    }
    Vector rising{};
    const auto squares = map_.squares(middle);
    for (std::size_t i = 0; i < 4; ++i) rising += -squares[i] * gradients_[i];
    const auto add = [&](const Vector& a, Vector b, Vector c) {
      if (!std::isfinite(dot(a, a) + dot(b, b) + dot(c, c))) return;
      if (dot(cross(b - a, c - a), rising) < 0) std::swap(b, c);
      out_.push_back({{a, b, c}, tet_});
    };
    if (n <= 4) {
      for (std::size_t k = 2; k < n; ++k) add(places[0], places[k - 1], places[k]);
      return;
    }
    const Vector centre = image(vertex(middle, sign));
    for (std::size_t k = 0; k < n; ++k) add(centre, places[k], places[(k + 1) % n]);
  }

  const std::array<FieldPoint, 4>& corners_;
  NeutralMap map_;
  SurfaceMesh::Index tet_;
  double tolerance_ = 0;
  std::array<Vector, 4> gradients_{};  ///< of the barycentric coordinates
  std::array<double, 4> heights_{};    ///< of the corners over their faces
  std::vector<Cell> cells_;
  std::vector<Leaf> leaves_;
  std::set<Vector, InOrder> middles_;  ///< of sides that were cut
  std::vector<SoupTriangle>& out_;
};

}  // namespace

bool add_hybrid(const std::array<FieldPoint, 4>& corners, SurfaceMesh::Index tet, double tolerance,
                std::vector<SoupTriangle>& out) {
  const std::size_t before = out.size();
  if (Hybrid(corners, tet, tolerance, out).run()) return true;
  out.resize(before);
  return false;
}

}  // namespace tensortopo::baselines
