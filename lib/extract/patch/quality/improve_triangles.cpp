// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/improve_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "extract/level/level_in_tet.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/renumber.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;
using Vector = Vector3<double>;
using Corners = std::array<Index, 3>;

/// Some triangles, as good as the worst of them.
struct Shape {
  double least_sine = 1;  ///< of the least angles, which are at most 60 degrees
  double squares = 0;     ///< squared distances to the level at the centroids, by area
};

class Improver {
 public:
  Improver(const TetMesh& mesh, const ModeValue& mode, SurfaceMesh& surface)
      : mesh_(mesh), field_(mesh), level_(make_level<double>(mode)), surface_(surface) {
    triangles_at_.resize(surface.points.size());
    moved_.assign(surface.points.size(), 0);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      for (const Index v : surface.triangles[i])
        triangles_at_[as_size(v)].push_back(static_cast<Index>(i));
  }

  ImprovementCounts run(int rounds) {
    ImprovementCounts counts;
    counts.before = angles();
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < surface_.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) counts.flipped += flip(static_cast<Index>(i), k);
      for (std::size_t v = 0; v < surface_.points.size(); ++v) {
        const auto carrier = surface_.carrier[v];
        if (carrier == Carrier::tet) counts.moved_in_tets += smooth(static_cast<Index>(v));
        if (carrier == Carrier::face) counts.moved_along_faces += slide(static_cast<Index>(v));
      }
    }
    for (std::size_t v = 0; v < surface_.points.size(); ++v)
      if (moved_[v] != 0) describe(v);
    counts.after = angles();
    return counts;
  }

 private:
  /// The level in a triangle's tetrahedron; nothing where the mode is undefined at a corner.
  std::optional<LevelInTet> level_in(Index tet) const {
    for (const auto v : mesh_.tets[as_size(tet)])
      if (field_.is_zero[as_size(v)] != 0) return std::nullopt;
    return LevelInTet(mesh_, field_, tet, level_);
  }

  Vector normal(const Corners& t) const {
    const auto& p = surface_.points;
    return cross(p[as_size(t[1])] - p[as_size(t[0])], p[as_size(t[2])] - p[as_size(t[0])]);
  }

  void add(Shape& shape, const Corners& t, const LevelInTet& level) const {
    const auto &p = surface_.points[as_size(t[0])], &q = surface_.points[as_size(t[1])],
               &r = surface_.points[as_size(t[2])];
    const Vector n = normal(t);
    const double twice_area = length(n);
    shape.least_sine = std::min(shape.least_sine, least_sine(p, q, r, twice_area));
    const double distance = level.distance((1.0 / 3) * (p + q + r));
    shape.squares += twice_area * distance * distance;
  }

  AngleSummary angles() const {
    if (surface_.triangles.empty()) return {};
    AngleSummary summary;
    double sum = 0;
    for (const Corners& t : surface_.triangles) {
      const auto &p = surface_.points[as_size(t[0])], &q = surface_.points[as_size(t[1])],
                 &r = surface_.points[as_size(t[2])];
      const double angle =
          elementary::asin(std::min(1.0, least_sine(p, q, r, length(normal(t))))) * 180 / std::numbers::pi;
      summary.least = std::min(summary.least, angle);
      sum += angle;
    }
    summary.mean = sum / static_cast<double>(surface_.triangles.size());
    return summary;
  }

  /// Whether the new shape is worth the change: clearly better angles, at no cost in distance.
  static bool is_better(const Shape& now, const Shape& then) {
    constexpr double kWorth = 1.01;
    return now.least_sine > kWorth * then.least_sine && now.squares <= then.squares;
  }

  /// Triangles of a tetrahedron's sheet go on facing larger modes.
  bool faces_up(const Corners& t) const {
    const Vector n = normal(t);
    const double length = std::sqrt(dot(n, n));
    constexpr double kFlattest = 0.5;
    return std::all_of(t.begin(), t.end(), [&](Index v) {
      const Vector& up = surface_.normal[as_size(v)];
      return !(dot(n, up) < kFlattest * length);
    });
  }

  bool is_edge(Index a, Index b) const {
    const auto& around = triangles_at_[as_size(a)];
    return std::any_of(around.begin(), around.end(), [&](Index i) {
      const auto& t = surface_.triangles[as_size(i)];
      return std::find(t.begin(), t.end(), b) != t.end();
    });
  }

  /// Whether some face of the mesh holds both.
  bool on_one_face(Index a, Index b) const {
    std::vector<Index> corners;
    for (const Index v : {a, b})
      for (const Index c : surface_.carrier_vertices[as_size(v)])
        if (c >= 0) corners.push_back(c);
    std::sort(corners.begin(), corners.end());
    return std::unique(corners.begin(), corners.end()) - corners.begin() <= 3;
  }

  void replace_at(Index v, Index old_triangle, Index new_triangle) {
    auto& around = triangles_at_[as_size(v)];
    const auto place = std::find(around.begin(), around.end(), old_triangle);
    if (new_triangle < 0)
      around.erase(place);
    else
      around.push_back(new_triangle);
  }

  /// Replaces the edge of triangle i after its corner k by the other diagonal, if that is better.
  bool flip(Index i, std::size_t k) {
    Corners& one = surface_.triangles[as_size(i)];
    const Index a = one[k], b = one[(k + 1) % 3], c = one[(k + 2) % 3];
    Index j = -1;
    for (const Index other : triangles_at_[as_size(a)]) {
      const auto& t = surface_.triangles[as_size(other)];
      if (other != i && std::find(t.begin(), t.end(), b) != t.end()) j = other;
    }
    // Each pair once. A boundary loop has a triangle in each of two tetrahedra.
    if (j < i || surface_.tet[as_size(j)] != surface_.tet[as_size(i)]) return false;
    Corners& two = surface_.triangles[as_size(j)];
    const Index d = two[0] + two[1] + two[2] - a - b;
    if (c == d || on_one_face(a, b) || on_one_face(c, d) || is_edge(c, d)) return false;
    const auto level = level_in(surface_.tet[as_size(i)]);
    if (!level) return false;
    const Corners new_one{a, d, c}, new_two{d, b, c};
    Shape then, now;
    add(then, one, *level);
    add(then, two, *level);
    add(now, new_one, *level);
    add(now, new_two, *level);
    if (!is_better(now, then) || !faces_up(new_one) || !faces_up(new_two)) return false;
    one = new_one;
    two = new_two;
    replace_at(a, j, -1);
    replace_at(b, i, -1);
    replace_at(c, -1, j);
    replace_at(d, -1, i);
    return true;
  }

  /// Moves a vertex towards a place, at most all the way, if that is better.
  bool move(Index v, const Vector& target, std::span<const LevelInTet> levels, std::size_t across) {
    const auto& around = triangles_at_[as_size(v)];
    const Vector old = surface_.points[as_size(v)];
    Shape then;
    std::vector<Vector> normals;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const auto& t = surface_.triangles[as_size(around[i])];
      add(then, t, levels[i]);
      normals.push_back(normal(t));
    }
    for (const double share : {1.0, 0.5, 0.25}) {
      const auto place = levels[0].on_level(old + share * (target - old), across);
      if (!place || !(std::abs(levels[0].residual(*place)) <= kLargestResidual)) continue;
      surface_.points[as_size(v)] = *place;
      Shape now;
      bool is_upright = true;
      for (std::size_t i = 0; i < around.size(); ++i) {
        const auto& t = surface_.triangles[as_size(around[i])];
        add(now, t, levels[i]);
        is_upright &= dot(normal(t), normals[i]) > 0 && faces_up(t);
      }
      if (is_upright && is_better(now, then)) {
        moved_[as_size(v)] = 1;
        return true;
      }
    }
    surface_.points[as_size(v)] = old;
    return false;
  }

  /// The levels in the tetrahedra of the triangles around a vertex, if defined.
  std::optional<std::vector<LevelInTet>> levels_around(Index v) const {
    std::vector<LevelInTet> levels;
    for (const Index i : triangles_at_[as_size(v)]) {
      auto level = level_in(surface_.tet[as_size(i)]);
      if (!level) return std::nullopt;
      levels.push_back(*level);
    }
    if (levels.empty()) return std::nullopt;
    return levels;
  }

  /// A vertex inside a tetrahedron towards the mean of its neighbours.
  bool smooth(Index v) {
    const auto levels = levels_around(v);
    if (!levels) return false;
    Vector sum{0, 0, 0};
    double count = 0;
    for (const Index i : triangles_at_[as_size(v)])
      for (const Index u : surface_.triangles[as_size(i)])
        if (u != v) {  // each neighbour twice
          sum += surface_.points[as_size(u)];
          ++count;
        }
    return move(v, (1 / count) * sum, *levels, 4);
  }

  /// A vertex inside a face of the mesh towards the middle between its neighbours on the curve.
  bool slide(Index v) {
    std::vector<Index> neighbours;
    for (const Index i : triangles_at_[as_size(v)])
      for (const Index u : surface_.triangles[as_size(i)])
        if (u != v && on_one_face(u, v) &&
            std::find(neighbours.begin(), neighbours.end(), u) == neighbours.end())
          neighbours.push_back(u);
    if (neighbours.size() != 2) return false;
    const auto levels = levels_around(v);
    if (!levels) return false;
    const auto& tet = mesh_.tets[as_size(surface_.tet[as_size(triangles_at_[as_size(v)][0])])];
    const auto& face = surface_.carrier_vertices[as_size(v)];
    const auto is_off_face = [&](Index c) {
      return std::find(face.begin(), face.end(), c) == face.end();
    };
    const auto across =
        static_cast<std::size_t>(std::find_if(tet.begin(), tet.end(), is_off_face) - tet.begin());
    const auto &p = surface_.points[as_size(neighbours[0])],
               &q = surface_.points[as_size(neighbours[1])];
    return move(v, 0.5 * (p + q), *levels, across);
  }

  /// Says anew what is known at a vertex that moved.
  void describe(std::size_t v) {
    const Vector& x = surface_.points[v];
    std::vector<Index> tets;
    for (const Index i : triangles_at_[v]) tets.push_back(surface_.tet[as_size(i)]);
    std::sort(tets.begin(), tets.end());
    tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
    Vector sum{0, 0, 0};
    for (const Index t : tets) sum += unit_or_zero(level_in(t)->mode_gradient(x));
    const auto level = *level_in(tets.front());
    const auto t = level.tensor(x);
    surface_.normal[v] = unit_or_zero(sum);
    surface_.residual[v] = level.residual(x);
    surface_.medium_eigenvector[v] = medium_eigenvector(t, level_);
    surface_.dominant_eigenvector[v] = dominant_eigenvector(t, level_);
  }

  static constexpr double kLargestResidual = 1e-13;

  const TetMesh& mesh_;
  const ScaledField<double> field_;
  const Level<double> level_;
  SurfaceMesh& surface_;
  std::vector<std::vector<Index>> triangles_at_;
  std::vector<char> moved_;
};

}  // namespace

ImprovementCounts improve_triangles(const TetMesh& mesh, const ModeValue& mode,
                                    SurfaceMesh& surface, int rounds) {
  const CanonicalMesh canonical = canonical_mesh(mesh);
  renumber(surface, inverse_permutation(canonical.vertices), inverse_permutation(canonical.tets));
  const auto counts = Improver(canonical.mesh, mode, surface).run(rounds);
  renumber(surface, canonical.vertices, canonical.tets);
  return counts;
}

}  // namespace tensortopo
