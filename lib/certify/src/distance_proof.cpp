// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distance_proof.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tensortopo/extract/simple_simplex.hpp"
#include "tensortopo/extract/tet_geometry.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

/// A triangle that is not proved has its reaches multiplied by 2^(kStep/4), at most this often.
constexpr int kStep = 2;
constexpr int kRounds = 20;
/// A reach starts at so much of what the mode at a few places asks for.
constexpr double kMargin = 1.5;
/// Of the way to the end of its edge, face or tetrahedron a vertex may go.
constexpr double kRoom = 0.45;

std::size_t as_size(Index i) { return static_cast<std::size_t>(i); }

template <class Body>
void for_each(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 512), [&](const auto& range) {
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

  /// The side of the level on which a triangle lies, if it is proved to lie on one.
  Verdict side(const std::array<std::array<double, 4>, 3>& corners,
               const Level<double>& level) const {
    std::array<Deviator<double>, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double w : corners[i])
        if (!(w >= 0)) return Verdict::unknown;
      t[i] = geometry_.tensor(corners[i], tensors_);
    }
    const Verdict side = side_of_level(t[0], level, total_);
    return side != Verdict::unknown && is_proved_empty(t, level, total_) ? side : Verdict::unknown;
  }

  double size() const { return geometry_.longest_edge(); }

 private:
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
            const ScaledField<double>& field, const Level<double>& level)
      : mesh_(mesh), surface_(surface), triangles_(triangles), field_(field), level_(level) {}

  void start() {
    const std::size_t count = triangles_.size();
    std::vector<std::array<double, 4>> asked(count);  // reach, then room of each corner
    for_each(count, [&](std::size_t i) {
      const Cell cell(mesh_, field_, surface_.tet[triangles_[i]]);
      const auto corners = corners_of(cell, triangles_[i]);
      std::array<double, 4> centre{};
      double farthest = 0x1p-44 * cell.size();
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, 4> middle;
        for (std::size_t k = 0; k < 4; ++k) {
          middle[k] = 0.5 * (corners[c].weights[k] + corners[(c + 1) % 3].weights[k]);
          centre[k] += corners[c].weights[k] / 3;
        }
        const double d = cell.distance(middle, level_);
        if (d < cell.size()) farthest = std::max(farthest, d);
        asked[i][c + 1] = kRoom * corners[c].room();
      }
      const double d = cell.distance(centre, level_);
      if (d < cell.size()) farthest = std::max(farthest, d);
      asked[i][0] = kMargin * farthest;
    });
    const auto vertices = surface_.points.size();
    std::vector<double> reach(vertices, 0), room(vertices, std::numeric_limits<double>::max());
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto v = as_size(surface_.triangles[triangles_[i]][c]);
        reach[v] = std::max(reach[v], asked[i][0]);
        room[v] = std::min(room[v], asked[i][c + 1]);
      }
    reach_.resize(vertices);
    most_.resize(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      // A vertex in a corner of its carrier can hardly move, or not at all.
      most_[v] = room[v] > 0 ? reach_of(room[v]) - 1 : reach_of(0x1p-1000);
      reach_[v] = std::min(reach_of(std::max(reach[v], 0x1p-1000)), most_[v]);
    }
  }

  /// Tries all triangles, and those again whose reaches grew. Leaves those that are not proved.
  std::vector<std::size_t> run() {
    std::vector<std::size_t> trying(triangles_.begin(), triangles_.end());
    std::vector<char> proved(surface_.triangles.size(), 0), grown(surface_.points.size(), 0);
    for (int round = 0; round < kRounds && !trying.empty(); ++round) {
      for_each(trying.size(), [&](std::size_t k) { proved[trying[k]] = is_proved(trying[k]); });
      std::fill(grown.begin(), grown.end(), 0);
      bool any = false;
      for (const auto i : trying)
        if (!proved[i])
          for (const Index v : surface_.triangles[i])
            if (!grown[as_size(v)] && reach_[as_size(v)] < most_[as_size(v)]) {
              reach_[as_size(v)] = std::min(reach_[as_size(v)] + kStep, most_[as_size(v)]);
              grown[as_size(v)] = 1;
              any = true;
            }
      if (!any) break;
      trying.clear();
      for (const auto i : triangles_)
        for (const Index v : surface_.triangles[i])
          if (grown[as_size(v)]) {
            trying.push_back(i);
            break;
          }
    }
    for_each(trying.size(), [&](std::size_t k) { proved[trying[k]] = is_proved(trying[k]); });
    std::vector<std::size_t> left;
    for (const auto i : triangles_)
      if (!proved[i]) left.push_back(i);
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
    return cell.side(ahead, level_) == Verdict::positive &&
           cell.side(behind, level_) == Verdict::negative;
  }

  const TetMesh& mesh_;
  const SurfaceMesh& surface_;
  std::span<const std::size_t> triangles_;
  const ScaledField<double>& field_;
  const Level<double>& level_;
  std::vector<int> reach_, most_;
};

bool meets_an_edge(const LevelTopology::Sheet& sheet, const SurfaceMesh& surface) {
  return std::any_of(sheet.loops.begin(), sheet.loops.end(), [&](const auto& loop) {
    return surface.carrier[as_size(loop[0].from)] == Carrier::edge;
  });
}

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
  Distances distances(mesh, surface, triangles, field, level);
  distances.start();
  for (const auto i : distances.run()) claim.coarse.push_back(surface.tet[i]);
  for (const auto& tet : topology.tets)
    for (const auto& sheet : tet.sheets)
      if (!meets_an_edge(sheet, surface)) claim.coarse.push_back(tet.tet);
  std::sort(claim.coarse.begin(), claim.coarse.end());
  claim.coarse.erase(std::unique(claim.coarse.begin(), claim.coarse.end()), claim.coarse.end());
  // Positions are rounded, and so are the directions' lengths.
  constexpr double kAbove = 1 + 0x1p-20;
  for (const Index t : claim.coarse)
    claim.coarse_bound = std::max(claim.coarse_bound, kAbove * distances.size_of(t));
  claim.reach = std::move(distances).reach();
  std::vector<char> is_coarse(mesh.tets.size(), 0);
  for (const Index t : claim.coarse) is_coarse[as_size(t)] = 1;
  for (const auto i : triangles)
    if (!is_coarse[as_size(surface.tet[i])])
      for (const Index v : surface.triangles[i])
        claim.bound =
            std::max(claim.bound, kAbove * reach_length(claim.reach[as_size(v)]));
  return claim;
}

}  // namespace tensortopo
