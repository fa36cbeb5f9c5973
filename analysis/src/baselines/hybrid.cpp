// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "baselines/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "baselines/direction_cell.hpp"
#include "baselines/edge_roots.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo::baselines {

namespace {

using Vector = Vector3<double>;

constexpr int kDeepest = 60;             // of a triangle of directions: 2^-30 of the sphere's
constexpr std::size_t kMost = 4000;      // triangles of directions for one tetrahedron

/// One of v and -v.
bool is_turned(const Vector& v) { return v.x != 0 ? v.x < 0 : v.y != 0 ? v.y < 0 : v.z < 0; }

struct Leaf {
  std::array<Vector, 3> corners;
  std::array<bool, 3> singular{};
  double sign = 1;  ///< of the weights inside
};

/// A direction; of a singularity, its place as it is approached from another direction.
struct Vertex {
  Vector v;
  std::array<double, 4> weights{};  ///< up to a factor
  unsigned faces = 0;               ///< those that it is on
  bool singular = false;
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
    tolerance_.distance = tolerance * longest;
    const double volume = dot(cross(place(1) - place(0), place(2) - place(0)), place(3) - place(0));
    const auto gradient = [&](std::size_t a, std::size_t b, std::size_t c) {
      return (1 / volume) * cross(place(b) - place(a), place(c) - place(a));
    };
    gradients_ = {-gradient(1, 2, 3), gradient(0, 2, 3), -gradient(0, 1, 3), gradient(0, 1, 2)};
    for (std::size_t i = 0; i < 4; ++i) {
      tolerance_.places[i] = place(i);
      tolerance_.heights[i] = 1 / length(gradients_[i]);
    }
  }

  bool run() {
    const auto found = characteristic_tensor(TetrahedronField<double>{
        {corners_[0].tensor, corners_[1].tensor, corners_[2].tensor, corners_[3].tensor}});
    if (!found) return false;
    const auto& [high, middle, low] = found->eigenvalues;
    const Vector e = std::sqrt((high - middle) / (high - low)) * found->eigenvectors[0],
                 f = std::sqrt((middle - low) / (high - low)) * found->eigenvectors[2];
    if (!(length(e) > 1e-4)) return false;
    const Vector n = found->eigenvectors[1], s = polished(e + f, e - f, n),
                 t = polished(f - e, e + f, n);
    // Half of an octahedron.
    for (const auto& start : {std::array{s, t, n}, {-s, t, n}, {s, -t, n}, {-s, -t, n}}) {
      DirectionCell cell{start, map_.on(start), {true, true, false}, 0};
      for (Cubic& b : cell.weights) b[kCorner[0]] = b[kCorner[1]] = 0;
      cells_.push_back(cell);
    }
    for (std::size_t done = 0; !cells_.empty(); ++done) {
      if (done == kMost) return false;
      const DirectionCell cell = cells_.back();
      cells_.pop_back();
      const auto [positive, negative] = possible_signs(cell);
      if (!positive && !negative) continue;
      const double sign = positive ? 1 : -1;
      if (cell.depth == kDeepest) continue;  // next to a singularity, to rounding
      if (positive != negative && is_flat(cell, sign, tolerance_))
        leaves_.push_back({cell.corners, cell.singular, sign});
      else
        cut(cell);
    }
    for (const Leaf& leaf : leaves_) mesh(leaf);
    return true;
  }

 private:
  const Vector& place(std::size_t i) const { return corners_[i].position; }

  /// A singularity by Gauss and Newton's method, from nearby, along d and e.
  Vector polished(Vector v, const Vector& d, const Vector& e) const {
    for (int step = 0; step < 4; ++step) {
      const auto b = map_.weights(v), p = map_.slopes(v, d), q = map_.slopes(v, e);
      double pp = 0, pq = 0, qq = 0, bp = 0, bq = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        pp += p[i] * p[i], pq += p[i] * q[i], qq += q[i] * q[i];
        bp += b[i] * p[i], bq += b[i] * q[i];
      }
      const double det = pp * qq - pq * pq;
      const double x = (pq * bq - qq * bp) / det, y = (pq * bp - pp * bq) / det;
      if (!(std::abs(x) + std::abs(y) < 0.01)) break;
      v = v + x * d + y * e;
    }
    return v;
  }

  void cut(const DirectionCell& cell) {
    for (const DirectionCell& half : halves(cell)) {
      const Vector& m = half.corners[2];
      middles_.insert(is_turned(m) ? -m : m);
      cells_.push_back(half);
    }
  }

  Vertex vertex(const Vector& v, double sign) const {
    Vertex result{v, map_.weights(v)};
    for (double& b : result.weights) b *= sign;
    return result;
  }

  Vertex singular_vertex(const Vector& v, const Vector& towards, double sign) const {
    Vertex result{v, map_.slopes(v, towards - v), 0, true};
    for (double& b : result.weights) b *= sign;
    return result;
  }

  /// The corners of finer neighbours between a and b, in order.
  void add_between(const Vector& a, const Vector& b, std::vector<Vector>& out) const {
    const Vector m = 0.5 * (a + b);
    if (!middles_.contains(is_turned(m) ? -m : m)) return;
    add_between(a, m, out);
    out.push_back(m);
    add_between(m, b, out);
  }

  std::vector<Vertex> outline(const Leaf& leaf) const {
    std::vector<Vector> around;
    std::vector<bool> singular;
    for (std::size_t a = 0; a < 3; ++a) {
      around.push_back(leaf.corners[a]);
      singular.push_back(leaf.singular[a]);
      add_between(leaf.corners[a], leaf.corners[(a + 1) % 3], around);
      singular.resize(around.size(), false);
    }
    std::vector<Vertex> polygon;
    for (std::size_t k = 0, n = around.size(); k < n; ++k) {
      if (!singular[k]) {
        polygon.push_back(vertex(around[k], leaf.sign));
        continue;
      }
      polygon.push_back(singular_vertex(around[k], around[(k + n - 1) % n], leaf.sign));
      polygon.push_back(singular_vertex(around[k], around[(k + 1) % n], leaf.sign));
    }
    return polygon;
  }

  void mesh(const Leaf& leaf) {
    std::vector<Vertex> polygon = outline(leaf), clipped;
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
    if (p.singular != q.singular ? q.singular
                                 : comes_first(turned ? -q.v : q.v, turned ? -p.v : p.v))
      return crossing(q, p, i, leaf);
    // From a singularity on all weights grow like t: that is no zero to be found.
    const auto at = [&](double t) {
      const double f = leaf.sign * map_.weights(p.v + t * (q.v - p.v))[i];
      return p.singular ? f / t : f;
    };
    double low = 0, high = 1, f_low = p.weights[i], f_high = q.weights[i];
    double t = f_low / (f_low - f_high);
    const auto at_singularity = [&](double share) {
      Vertex result = p;
      for (std::size_t k = 0; k < 4; ++k)
        result.weights[k] = p.weights[k] + share * (q.weights[k] - p.weights[k]);
      result.weights[i] = 0;
      result.faces = 1U << i | (p.faces & q.faces);
      return result;
    };
    if (p.singular && q.singular) return at_singularity(t);
    for (int step = 0; step < 60 && t > low && t < high; ++step) {
      const double f = at(t);
      if (f == 0) break;
      // False position, with the Illinois rule.
      if ((f > 0) == (f_low > 0)) {
        low = t, f_low = f, f_high *= 0.5;
      } else {
        high = t, f_high = f, f_low *= 0.5;
      }
      t = low + (high - low) * (f_low / (f_low - f_high));
    }
    if (p.singular && t < 1e-9) return at_singularity(0);
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
    // There all weights vanish.
    for (std::size_t a = 0; a < 3; ++a)
      if (leaf.singular[a] && length(v - leaf.corners[a]) < 1e-6 * (length(d) + length(e)))
        return std::nullopt;
    Vertex result = vertex(v, leaf.sign);
    result.faces = 1U << i | 1U << j;
    return result;
  }

  Vector image(const Vertex& p) const {
    // A weight that clipping has left below zero stays: better outside than off the surface.
    const auto& b = p.weights;
    const double sum = b[0] + b[1] + b[2] + b[3];
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
  CellTolerance tolerance_;
  std::array<Vector, 4> gradients_{};  ///< of the barycentric coordinates
  std::vector<DirectionCell> cells_;
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
