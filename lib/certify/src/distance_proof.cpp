// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distance_proof.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "closed_rims.hpp"
#include "tensortopo/extract/simple_simplex.hpp"
#include "tensortopo/extract/tet_geometry.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

/// A triangle that is not proved has its reaches multiplied by 2^(kStep/4), to no more than
/// 2^(kGrowth/4) times what it asked for.
constexpr int kStep = 2;
constexpr int kGrowth = 10;
constexpr int kAttempts = 4;
/// How often a moved triangle is cut in four for the proof that the level does not meet it.
constexpr int kCuts = 2;
constexpr int kShortest = -4000;
/// A reach starts at so much of what the mode at a few places asks for.
constexpr double kMargin = 1.5;
/// A flat triangle asks for next to nothing, less than can be proved in double: in any case the
/// reaches may grow to so much of the tetrahedron's size.
constexpr double kFlat = 0x1p-20;
/// Of the way to the end of its edge, face or tetrahedron a vertex may go.
constexpr double kRoom = 0.98;

std::size_t as_size(Index i) { return static_cast<std::size_t>(i); }

template <class Body>
void for_each(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 512), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

Vector3<double> unit(const Vector3<double>& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vector3<double>{0, 0, 0};
}

/// A corner of a triangle: its weights in the tetrahedron, exactly 0 off its carrier, and how they
/// change along the unit direction in which it may move.
struct Corner {
  std::array<double, 4> weights{}, step{};

  std::array<double, 4> moved(double by) const {
    std::array<double, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = weights[i] + by * step[i];
    return result;
  }
  /// How far it may move both ways without leaving the carrier.
  double room() const {
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i)
      if (step[i] != 0) room = std::min(room, weights[i] / std::abs(step[i]));
    return room;
  }
};

/// One tetrahedron and the level in it.
class Cell {
 public:
  Cell(const TetMesh& mesh, const ScaledField<double>& field, Index tet)
      : vertices_(mesh.tets[as_size(tet)]), geometry_(points(mesh), exponents(field)) {
    for (std::size_t i = 0; i < 4; ++i) tensors_[i] = field.tensors[as_size(vertices_[i])];
    // Errors of the weights count as those of exact weights do (see rounding_unit): four terms,
    // each below sqrt(12) times it.
    total_ = 1 + geometry_.weight_error() / unit_roundoff<double>();
  }

  Corner corner(const SurfaceMesh& surface, Index vertex, const Level<double>& level) const {
    const auto& carrier = surface.carrier_vertices[as_size(vertex)];
    const auto& x = surface.points[as_size(vertex)];
    Corner corner;
    std::array<bool, 4> carried;
    for (std::size_t i = 0; i < 4; ++i) {
      carried[i] = std::find(carrier.begin(), carrier.end(), vertices_[i]) != carrier.end();
      if (carried[i]) corner.weights[i] = std::max(0.0, geometry_.weight(i, x));
    }
    const auto at = level_slope(geometry_.tensor(corner.weights, tensors_), level);
    auto direction = geometry_.gradient(at.slope, tensors_);
    std::array<std::size_t, 4> on{}, off{};
    std::size_t on_count = 0, off_count = 0;
    for (std::size_t i = 0; i < 4; ++i) (carried[i] ? on[on_count++] : off[off_count++]) = i;
    if (off_count == 1) {
      const auto normal = unit(geometry_.weight_gradient(off[0]));
      direction = direction - dot(direction, normal) * normal;
    } else if (off_count == 2) {
      const auto along = unit(cross(geometry_.weight_gradient(off[0]),
                                    geometry_.weight_gradient(off[1])));
      direction = dot(direction, along) * along;
    }
    direction = unit(direction);
    for (std::size_t k = 0; k < on_count; ++k)
      corner.step[on[k]] = dot(geometry_.weight_gradient(on[k]), direction);
    return corner;
  }

  /// About how far the level is from a place, along the gradient.
  double distance(const std::array<double, 4>& weights, const Level<double>& level) const {
    const auto at = level_slope(geometry_.tensor(weights, tensors_), level);
    const auto g = geometry_.gradient(at.slope, tensors_);
    return std::abs(at.value) / std::sqrt(dot(g, g));
  }

  /// Whether a triangle is proved to lie on one side of the level.
  bool is_on_side(const std::array<std::array<double, 4>, 3>& corners, Verdict side,
                  const Level<double>& level) const {
    std::array<Deviator<double>, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double w : corners[i])
        if (!(w >= 0)) return false;
      t[i] = geometry_.tensor(corners[i], tensors_);
    }
    return is_on_side(t, side, level, kCuts);
  }

  double size() const { return geometry_.longest_edge(); }

 private:
  bool is_on_side(const std::array<Deviator<double>, 3>& t, Verdict side,
                  const Level<double>& level, int cuts) const {
    for (const auto& corner : t)
      if (side_of_level(corner, level, total_) != side) return false;
    if (is_proved_empty(t, level, total_)) return true;
    if (cuts == 0) return false;
    const std::array<Deviator<double>, 3> h{0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                                            0.5 * (t[0] + t[1])};
    return is_on_side(h, side, level, cuts - 1) &&
           is_on_side({t[0], h[2], h[1]}, side, level, cuts - 1) &&
           is_on_side({t[1], h[0], h[2]}, side, level, cuts - 1) &&
           is_on_side({t[2], h[1], h[0]}, side, level, cuts - 1);
  }

  std::array<Vector3<double>, 4> points(const TetMesh& mesh) const {
    std::array<Vector3<double>, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = mesh.points[as_size(vertices_[i])];
    return result;
  }
  std::array<int, 4> exponents(const ScaledField<double>& field) const {
    std::array<int, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = field.exponents[as_size(vertices_[i])];
    return result;
  }

  std::array<Index, 4> vertices_;
  TetGeometry geometry_;
  std::array<Deviator<double>, 4> tensors_;
  double total_ = 1;
};

class Distances {
 public:
  Distances(const TetMesh& mesh, const SurfaceMesh& surface, std::span<const std::size_t> triangles,
            const LevelTopology& topology, const ScaledField<double>& field,
            const Level<double>& level)
      : mesh_(mesh), surface_(surface), triangles_(triangles), topology_(topology), field_(field),
        level_(level) {}

  /// Finds reaches that prove as many triangles as possible; returns those that are left.
  std::vector<std::size_t> run() {
    measure();
    std::vector<char> given_up(surface_.triangles.size(), 0);
    // A triangle that is given up has made its neighbours' reaches longer: once more without it.
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      start(given_up);
      if (!grow(given_up)) break;
    }
    std::vector<std::size_t> left;
    for (const auto i : triangles_)
      if (given_up[i]) left.push_back(i);
    return left;
  }

  std::vector<int> reach() && { return std::move(reach_); }
  double size_of(Index tet) const { return Cell(mesh_, field_, tet).size(); }

 private:
  std::array<Corner, 3> corners_of(const Cell& cell, std::size_t triangle) const {
    const auto& v = surface_.triangles[triangle];
    return {cell.corner(surface_, v[0], level_), cell.corner(surface_, v[1], level_),
            cell.corner(surface_, v[2], level_)};
  }

  bool is_proved(std::size_t triangle) const {
    const Cell cell(mesh_, field_, surface_.tet[triangle]);
    const auto corners = corners_of(cell, triangle);
    std::array<std::array<double, 4>, 3> ahead, behind;
    for (std::size_t c = 0; c < 3; ++c) {
      const double by = reach_length(reach_[as_size(surface_.triangles[triangle][c])]);
      ahead[c] = corners[c].moved(by);
      behind[c] = corners[c].moved(-by);
    }
    return cell.is_on_side(ahead, Verdict::positive, level_) &&
           cell.is_on_side(behind, Verdict::negative, level_);
  }

  /// What each triangle asks for.
  void measure() {
    asked_.resize(surface_.triangles.size());
    limit_.resize(surface_.triangles.size());
    std::vector<std::array<double, 3>> rooms(surface_.triangles.size());
    for_each(triangles_.size(), [&](std::size_t k) {
      const auto i = triangles_[k];
      const Cell cell(mesh_, field_, surface_.tet[i]);
      const auto corners = corners_of(cell, i);
      std::array<double, 4> centre{};
      double farthest = 0x1p-44 * cell.size();
      const auto look = [&](const std::array<double, 4>& weights) {
        const double d = cell.distance(weights, level_);
        if (d < cell.size()) farthest = std::max(farthest, d);
      };
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, 4> middle;
        for (std::size_t j = 0; j < 4; ++j) {
          middle[j] = 0.5 * (corners[c].weights[j] + corners[(c + 1) % 3].weights[j]);
          centre[j] += corners[c].weights[j] / 3;
        }
        look(middle);
        rooms[i][c] = kRoom * corners[c].room();
      }
      look(centre);
      asked_[i] = reach_of(kMargin * farthest);
      limit_[i] = std::max(asked_[i] + kGrowth, reach_of(kFlat * cell.size()));
    });
    const auto vertices = surface_.points.size();
    std::vector<double> room(vertices, std::numeric_limits<double>::max());
    for (const auto i : triangles_)
      for (std::size_t c = 0; c < 3; ++c) {
        auto& least = room[as_size(surface_.triangles[i][c])];
        least = std::min(least, rooms[i][c]);
      }
    // Nor may it come to the next crossing of its edge.
    for (const auto& edge : topology_.edges)
      for (std::size_t k = 1; k < edge.crossings.size(); ++k) {
        const auto v = as_size(edge.crossings[k - 1].vertex), w = as_size(edge.crossings[k].vertex);
        const auto gap = surface_.points[w] - surface_.points[v];
        const double half = 0.49 * std::sqrt(dot(gap, gap));
        room[v] = std::min(room[v], half);
        room[w] = std::min(room[w], half);
      }
    most_.resize(vertices);
    // A vertex in a corner of its carrier can hardly move, or not at all.
    for (std::size_t v = 0; v < vertices; ++v)
      most_[v] = room[v] > 0x1p-999 ? reach_of(room[v]) - 1 : kShortest;
  }

  void start(const std::vector<char>& given_up) {
    reach_.assign(surface_.points.size(), kShortest);
    for (const auto i : triangles_)
      if (!given_up[i])
        for (const Index v : surface_.triangles[i])
          reach_[as_size(v)] =
              std::max(reach_[as_size(v)], std::min(asked_[i], most_[as_size(v)]));
  }

  /// Tries all triangles, and those again whose reaches grew. Gives up those that a few times what
  /// they asked for does not help; tells whether there are such.
  bool grow(std::vector<char>& given_up) {
    std::vector<std::size_t> trying;
    for (const auto i : triangles_)
      if (!given_up[i]) trying.push_back(i);
    std::vector<char> proved(surface_.triangles.size(), 0), grown(surface_.points.size(), 0);
    bool any_given_up = false;
    while (!trying.empty()) {
      for_each(trying.size(), [&](std::size_t k) { proved[trying[k]] = is_proved(trying[k]); });
      std::fill(grown.begin(), grown.end(), 0);
      bool any_grown = false;
      for (const auto i : trying) {
        if (proved[i]) continue;
        bool can_grow = false;
        for (const Index v : surface_.triangles[i]) {
          const int limit = std::min(limit_[i], most_[as_size(v)]);
          can_grow |= grown[as_size(v)] != 0;
          if (grown[as_size(v)] || reach_[as_size(v)] >= limit) continue;
          reach_[as_size(v)] = std::min(reach_[as_size(v)] + kStep, limit);
          grown[as_size(v)] = 1;
          any_grown = can_grow = true;
        }
        if (!can_grow) given_up[i] = 1, any_given_up = true;
      }
      if (!any_grown) break;
      trying.clear();
      for (const auto i : triangles_)
        if (!given_up[i] && std::any_of(surface_.triangles[i].begin(), surface_.triangles[i].end(),
                                        [&](Index v) { return grown[as_size(v)] != 0; }))
          trying.push_back(i);
    }
    return any_given_up;
  }

  const TetMesh& mesh_;
  const SurfaceMesh& surface_;
  std::span<const std::size_t> triangles_;
  const LevelTopology& topology_;
  const ScaledField<double>& field_;
  const Level<double>& level_;
  std::vector<int> asked_, limit_;  ///< by triangle
  std::vector<int> reach_, most_;  ///< by vertex
};

}  // namespace

double reach_length(int n) {
  const int exponent = n >= 0 ? n / 4 : -((3 - n) / 4);
  return std::ldexp(static_cast<double>(4 + (n - 4 * exponent)), exponent);
}

int reach_of(double length) {
  int n = 4 * (std::ilogb(length) - 2);
  while (reach_length(n) < length) ++n;
  return n;
}

DistanceClaim prove_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles,
                             const LevelTopology& topology, const ScaledField<double>& field,
                             const Level<double>& level) {
  DistanceClaim claim;
  Distances distances(mesh, surface, triangles, topology, field, level);
  for (const auto i : distances.run()) claim.coarse.push_back(surface.tet[i]);
  claim.reach = std::move(distances).reach();
  const auto uncovered = uncovered_closed_rims(surface, triangles, topology, claim.reach);
  claim.coarse.insert(claim.coarse.end(), uncovered.begin(), uncovered.end());
  std::sort(claim.coarse.begin(), claim.coarse.end());
  claim.coarse.erase(std::unique(claim.coarse.begin(), claim.coarse.end()), claim.coarse.end());
  // Positions are rounded, and so are the directions' lengths.
  constexpr double kAbove = 1 + 0x1p-20;
  for (const Index t : claim.coarse)
    claim.coarse_bound = std::max(claim.coarse_bound, kAbove * distances.size_of(t));
  std::vector<char> is_coarse(mesh.tets.size(), 0);
  for (const Index t : claim.coarse) is_coarse[as_size(t)] = 1;
  for (const auto i : triangles)
    if (!is_coarse[as_size(surface.tet[i])])
      for (const Index v : surface.triangles[i]) {
        // A position is rounded off the edge or face that holds the vertex.
        const auto& x = surface.points[as_size(v)];
        const double rounding = 0x1p-48 * (std::abs(x.x) + std::abs(x.y) + std::abs(x.z) +
                                           distances.size_of(surface.tet[i]));
        claim.bound = std::max(claim.bound,
                               kAbove * (reach_length(claim.reach[as_size(v)]) + rounding));
      }
  return claim;
}

}  // namespace tensortopo
