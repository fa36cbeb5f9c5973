// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

// Marching triangles on the triangle n >= x >= y >= 0 of the integer lattice; a point has
// barycentric coordinates (n - x, x - y, y).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "brute_force.hpp"
#include "lattice_counter.hpp"

namespace tensortopo::test {

namespace {

class FaceMarcher {
 public:
  FaceMarcher(const TriangleCorners& corners, double mode, int n)
      : question_(corners, mode), n_(n), signs_(points(), 0), vertex_(3 * points(), -1) {
    for (int x = 0; x <= n; ++x) {
      for (int y = 0; y <= x; ++y) {
        const std::array<std::int64_t, 4> weights{n - x, x - y, y, 0};
        signs_[point(x, y)] = question_.is_above(weights);
      }
    }
  }

  // As for a tetrahedron; a triangle is looked at where the Lode angle at a corner is as near to
  // that of the level as the tensors turn across it.
  double cell_angle() const {
    Five<long double> dx{}, dy{}, diagonal{};
    for (std::size_t c = 0; c < 5; ++c) {
      dx[c] = (question_.corner(1)[c] - question_.corner(0)[c]) / n_;
      dy[c] = (question_.corner(2)[c] - question_.corner(1)[c]) / n_;
      diagonal[c] = dx[c] + dy[c];
    }
    const double step = static_cast<double>(
        std::sqrt(std::max({square_norm(dx), square_norm(dy), square_norm(diagonal)})));
    const double lode = std::acos(question_.mode()) / 3;
    double largest = 0;
    for (int x = 0; x <= n_; ++x) {
      for (int y = 0; y <= x; ++y) {
        Five<double> t;
        for (std::size_t c = 0; c < 5; ++c) {
          t[c] = static_cast<double>(question_.corner(0)[c] + x * dx[c] + y * dy[c]);
        }
        const double p = square_norm(t), angle = step / std::sqrt(p);
        const double mode = std::numbers::sqrt2 * cubic_form(t) / (p * std::sqrt(p));
        const double distance = std::abs(std::acos(std::clamp(mode, -1.0, 1.0)) / 3 - lode);
        if (!(distance > std::asin(std::min(angle, 1.0)))) largest = std::max(largest, angle);
      }
    }
    return largest;
  }

  FaceTopology run() {
    for (int x = 0; x < n_; ++x) {
      for (int y = 0; y <= x; ++y) {
        visit(point(x, y), point(x + 1, y), point(x + 1, y + 1), 0, 2, 1);
        if (y < x) visit(point(x, y), point(x, y + 1), point(x + 1, y + 1), 1, 2, 0);
      }
    }
    FaceTopology result;
    std::vector<int> balance(curves_count(), 0);  // vertices less segments: 1 for an arc
    for (int v = 0; v < curves_.size(); ++v) ++balance[index(curves_.find(v))];
    for (const int v : segments_) --balance[index(curves_.find(v))];
    for (int v = 0; v < curves_.size(); ++v) {
      if (curves_.find(v) != v) continue;
      (balance[index(v)] == 1 ? result.open_arcs : result.closed_loops) += 1;
    }
    for (int s = 0; s < n_; ++s) {
      result.edge_crossings[0] += signs_[point(s, 0)] != signs_[point(s + 1, 0)];
      result.edge_crossings[1] += signs_[point(s, s)] != signs_[point(s + 1, s + 1)];
      result.edge_crossings[2] += signs_[point(n_, s)] != signs_[point(n_, s + 1)];
    }
    return result;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::size_t points() const { return index((n_ + 1) * (n_ + 2) / 2); }
  std::size_t curves_count() const { return index(curves_.size()); }
  static std::size_t point(int x, int y) { return index(x * (x + 1) / 2 + y); }

  // The vertex on the edge that leaves point p in direction 0 (x), 1 (y) or 2 (both).
  int vertex(std::size_t p, std::size_t direction) {
    int& id = vertex_[3 * p + direction];
    if (id < 0) id = curves_.add();
    return id;
  }

  // The triangle a, b, c where c = a + (1, 1); `ab` and `bc` are directions of its short edges.
  void visit(std::size_t a, std::size_t b, std::size_t c, std::size_t ab, std::size_t ac,
             std::size_t bc) {
    const char sa = signs_[a], sb = signs_[b], sc = signs_[c];
    if (sa == sb && sb == sc) return;
    const int u = sa != sb ? vertex(a, ab) : vertex(a, ac);
    const int v = sb != sc ? vertex(b, bc) : vertex(a, ac);
    curves_.unite(u, v);
    segments_.push_back(u);
  }

  LevelQuestion question_;
  int n_;
  std::vector<char> signs_;
  std::vector<int> vertex_;
  UnionFind curves_;
  std::vector<int> segments_;  // one vertex of each
};

}  // namespace

FaceLatticeView lattice_face_view(const TriangleCorners& corners, double mode, int n) {
  if (n < 1 || n > 4096) throw std::invalid_argument("1 to 4096 intervals an edge");
  FaceMarcher marcher(corners, mode, n);
  return {marcher.run(), marcher.cell_angle()};
}

}  // namespace tensortopo::test
