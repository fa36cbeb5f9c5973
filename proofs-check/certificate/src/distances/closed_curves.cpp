// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/closed_curves.hpp"

#include <algorithm>

#include "claims/curve_names.hpp"

namespace certificate {
namespace {

/// The sign of the turn from a to b to c.
int side_of_turn(const Place<3>& a, const Place<3>& b, const Place<3>& c) {
  return sgn(determinant(std::array{a, b, c}));
}

/// How often a polygon winds around a point that is not on it: up-crossings less down-crossings of
/// one half of the line through the point and the first corner of the face.
long winding(const std::vector<Place<3>>& polygon, const Place<3>& around) {
  const auto is_up = [&](const Place<3>& p) { return around[1] * p[2] > around[2] * p[1]; };
  long result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place<3> &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (is_up(p) == is_up(q)) continue;
    const int side = side_of_turn(p, q, around);
    if (is_up(q) && side > 0) ++result;
    if (is_up(p) && side < 0) --result;
  }
  return result;
}

}  // namespace

bool is_covered(const LevelCase& c, const MovedVertices& moved, std::size_t tet,
                const std::vector<ClosedLoop>& loops) {
  for (const ClosedLoop& loop : loops) {
    const FaceTopology& face = face_opposite(c, tet, loop.opposite);
    const std::vector<Number> names = curve_names(c, face);
    const auto curve = std::find(names.begin(), names.end(), loop.vertices[0]);
    if (curve == names.end()) continue;
    const auto& points = face.level.refinement->points();
    auto [below, above] = face.level.loops[static_cast<std::size_t>(curve - names.begin())][0];
    if (points[below].above) std::swap(below, above);
    long degree = 0;
    for (const ClosedLoop& other : loops) {
      if (other.opposite != loop.opposite) continue;
      const auto polygon = [&](MovedVertices::Way way) {
        std::vector<Place<3>> result;
        for (const Number v : other.vertices)
          result.push_back(without(moved.place(v - c.vertices.first, way), 3));
        return result;
      };
      degree += winding(polygon(MovedVertices::kAhead), without(points[below].weights, 3)) -
                winding(polygon(MovedVertices::kBehind), without(points[above].weights, 3));
    }
    if (degree != 0) return true;
  }
  return false;
}

}  // namespace certificate
