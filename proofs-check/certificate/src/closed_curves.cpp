// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "closed_curves.hpp"

#include <algorithm>
#include <cmath>

#include "curve_names.hpp"
#include "regions.hpp"

namespace certificate {
namespace {

/// A point of a face, by weights of the exact tensors at its corners.
using Point = std::array<mpz_class, 3>;

Point moved_point(const LevelCase& c, const MovedVertices& moved, Number vertex,
                  MovedVertices::Way way, const FaceTopology& face) {
  const std::array<double, 4>& weights = moved.weights(vertex - c.claims.vertices[0], way);
  Point result;
  std::array<long, 3> exponents{};
  for (std::size_t i = 0; i < 3; ++i) {
    int e = 0;
    result[i] = std::ldexp(std::frexp(weights[i], &e), 53);
    exponents[i] = e + c.field.exponent(face.vertices[i]);
  }
  const long lowest = *std::min_element(exponents.begin(), exponents.end());
  for (std::size_t i = 0; i < 3; ++i)
    result[i] <<= static_cast<unsigned long>(exponents[i] - lowest);
  return result;
}

/// How often a polygon winds around a point that is not on it: up-crossings less down-crossings of
/// one half of the line through the point and the first corner of the face.
long winding(const std::vector<Point>& polygon, const Point& around) {
  const auto is_up = [&](const Point& p) { return around[1] * p[2] > around[2] * p[1]; };
  long result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (is_up(p) == is_up(q)) continue;
    const int turn = side_of(p, q, around);
    if (is_up(q) && turn > 0) ++result;
    if (is_up(p) && turn < 0) --result;
  }
  return result;
}

}  // namespace

bool is_covered(const LevelCase& c, const MovedVertices& moved, std::size_t tet,
                const std::vector<ClosedLoop>& loops) {
  const auto* found = std::lower_bound(
      c.topology.tets.data(), c.topology.tets.data() + c.topology.tets.size(), tet,
      [](const TetTopology& t, std::size_t n) { return t.tet < n; });
  for (const ClosedLoop& loop : loops) {
    const auto& vertices = c.input.tets[tet];
    const auto at = std::find(vertices.begin(), vertices.end(), loop.opposite) - vertices.begin();
    const FaceTopology* there = c.topology.face(face_of(vertices, static_cast<std::size_t>(at)));
    if (found == c.topology.tets.data() + c.topology.tets.size() || there == nullptr) continue;
    const FaceTopology& face = *there;
    const std::vector<Number> names = curve_names(c, *found, loop.opposite);
    const Number name = *std::min_element(loop.vertices.begin(), loop.vertices.end());
    const auto curve = std::find(names.begin(), names.end(), name);
    if (curve == names.end()) continue;
    const Refinement& refinement = *face.level.refinement;
    auto [below, above] = face.level.loops[static_cast<std::size_t>(curve - names.begin())][0];
    if (refinement.points()[below].above) std::swap(below, above);
    const auto place = [&](Refinement::Id id) {
      const auto& w = refinement.points()[id].weights;
      return Point{w[0], w[1], w[2]};
    };
    long degree = 0;
    for (const ClosedLoop& other : loops) {
      if (other.opposite != loop.opposite) continue;
      std::vector<Point> ahead, behind;
      for (const Number v : other.vertices) {
        ahead.push_back(moved_point(c, moved, v, MovedVertices::kAhead, face));
        behind.push_back(moved_point(c, moved, v, MovedVertices::kBehind, face));
      }
      degree += winding(ahead, place(below)) - winding(behind, place(above));
    }
    if (degree != 0) return true;
  }
  return false;
}

}  // namespace certificate
