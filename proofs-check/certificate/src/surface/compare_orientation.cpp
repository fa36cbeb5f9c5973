// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "claims/containment.hpp"
#include "claims/curve_names.hpp"
#include "claims/half_edges.hpp"
#include "places.hpp"
#include "mesh/exact_vectors.hpp"
#include "surface/compare_places.hpp"

namespace certificate {
namespace {

ExactVector from(const Point3& origin, const Point3& p) {
  return minus(exact(p), exact(origin));
}

/// Do larger values lie inside a closed curve of a face? It crosses edges of the refinement with
/// these at its left, seen from where the face's vertices are counter-clockwise; a polygon through
/// points of those edges turns likewise.
bool is_above_inside(const FaceTopology& face, std::size_t curve) {
  const auto& points = face.level.refinement->points();
  std::vector<std::array<mpq_class, 2>> polygon;
  for (const auto& [a, b] : face.level.loops[curve]) {
    Place<3> sum;
    for (std::size_t k = 0; k < 3; ++k) sum[k] = points[a].weights[k] + points[b].weights[k];
    const mpz_class total = sum[0] + sum[1] + sum[2];
    polygon.push_back({mpq_class(sum[1], total), mpq_class(sum[2], total)});
    for (mpq_class& x : polygon.back()) x.canonicalize();
  }
  mpq_class area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area > 0;
}

/// What came of one closed curve or sheet.
enum class Turn { right, wrong, unsure };

/// Why that is open.
constexpr const char* kNotDerived = "what it is compared with is not derived";
constexpr const char* kNoSize =
    "its polygon has no area, or its triangles no volume, beyond rounding";

/// The square root; about, of numbers of any size.
double root_of(const mpq_class& square) { return mpf_class(sqrt(mpf_class(square, 64))).get_d(); }

/// Does the polygon of a closed curve turn as the curve does, seen from outside?
/// @param reason  receives what is wrong, or why that is open
Turn turn_of(const LevelCase& c, std::size_t tet, const ClosedLoop& loop, std::string& reason) {
  reason = kNotDerived;
  if (c.topology.tet(tet) == nullptr && c.topology.cone(tet) == nullptr)
    return Turn::unsure;  // what is claimed there is refuted already
  const FaceTopology& face = face_opposite(c, tet, loop.opposite);
  const std::vector<Number> names = curve_names(c, face);
  const auto name = std::find(names.begin(), names.end(), loop.vertices[0]);
  if (name == names.end()) return Turn::unsure;
  const auto& vertices = c.input.tets[tet];
  const auto place = std::find(vertices.begin(), vertices.end(), loop.opposite) - vertices.begin();
  const bool is_turned = (place % 2 == 1) != (orientation(c.input, vertices) < 0);
  const bool above = is_above_inside(face, static_cast<std::size_t>(name - names.begin()));
  // The area as seen from where the face's vertices are counter-clockwise.
  const auto point = [&](std::size_t i) { return c.input.points[face.vertices[i]]; };
  const ExactVector normal = cross(from(point(0), point(1)), from(point(0), point(2)));
  ExactVector area;
  double around = 0, slack = 0;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Point3 &p = c.surface.points[loop.vertices[i]],
                 &q = c.surface.points[loop.vertices[(i + 1) % loop.vertices.size()]];
    const ExactVector part = cross(from(point(0), p), from(point(0), q));
    for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
    around += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    for (const double x : p) slack = std::max(slack, 8 * rounding_of(std::abs(x)));
  }
  mpq_class seen, length;
  for (std::size_t k = 0; k < 3; ++k) seen += area[k] * normal[k], length += normal[k] * normal[k];
  if (above == is_turned) seen = -seen;
  if (seen > 0) return Turn::right;
  // Squares, exactly: coordinates may be of any size.
  reason = kNoSize;
  if (!std::isfinite(around) || !std::isfinite(slack)) return Turn::unsure;
  const mpq_class most = mpq_class(around) * mpq_class(slack);
  if (seen * seen <= most * most * length) return Turn::unsure;
  const double size = root_of(seen * seen / (4 * length));
  reason = std::string("the values inside are ") + (above ? "larger" : "smaller") +
           ", the area of its polygon has the other sign: seen from outside about " +
           Json(above ? -size : size).dump();
  return Turn::wrong;
}

/// Six times the volume that triangles without boundary enclose.
mpq_class volume_of(const LevelCase& c, const std::vector<std::size_t>& triangles) {
  mpq_class sum;
  const auto corner = [&](std::size_t t, std::size_t i) -> const Point3& {
    return c.surface.points[c.surface.triangles[c.triangles.first + t][i]];
  };
  const Point3& origin = corner(triangles[0], 0);
  for (const std::size_t t : triangles) {
    const ExactVector ab = cross(from(origin, corner(t, 0)), from(origin, corner(t, 1)));
    const ExactVector d = from(origin, corner(t, 2));
    for (std::size_t k = 0; k < 3; ++k) sum += ab[k] * d[k];
  }
  return sum;
}

/// Larger values are where triangles are seen counter-clockwise: outside of a positive volume.
/// @param reason  receives what is wrong, or why that is open
Turn turn_of(const LevelCase& c, std::size_t tet, const std::vector<ClosedPiece>& pieces,
             std::string& reason) {
  reason = kNotDerived;
  std::map<long, long> above, outward;  // how many more are so, by Euler characteristics
  const TetTopology* const found = c.topology.tet(tet);
  if (found == nullptr || !found->decided) return Turn::unsure;
  std::string witness;
  for (const MeshSheet& sheet : found->sheets)
    if (sheet.loops.empty()) above[sheet.euler_characteristic] += sheet.above_inside ? 1 : -1;
  for (const ClosedPiece& piece : pieces) {
    const mpq_class volume = volume_of(c, piece.triangles);
    const int sign = sgn(volume);
    if (sign == 0) return reason = kNoSize, Turn::unsure;
    outward[piece.euler_characteristic] -= sign;
    witness += (witness.empty() ? "the volume that its triangles enclose has the other sign: from "
                                  "triangle "
                                : ", from triangle ") +
               std::to_string(c.triangles.first + piece.triangles[0]) + " on about " +
               Json(volume.get_d() / 6).dump();
  }
  reason = witness;
  return above == outward ? Turn::right : Turn::wrong;
}

}  // namespace

void compare_orientation(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger) {
  const std::string claimed = "larger values where the triangles are counter-clockwise";
  std::string open, why_open;
  const auto is_wrong = [&](std::size_t tet, const auto& part, const std::string& name) {
    std::string reason;
    const Turn turn = turn_of(c, tet, part, reason);
    if (turn == Turn::unsure && open.empty()) open = name, why_open = reason;
    if (turn == Turn::wrong) ledger.refute("orientation of " + name, claimed, reason);
    return turn == Turn::wrong;
  };
  for (const auto& [tet, loop] : placed.closed_curves)
    if (is_wrong(tet, loop, "the closed curve at vertex " + std::to_string(loop.vertices[0])))
      return;
  for (const auto& [tet, pieces] : placed.closed_pieces)
    if (is_wrong(tet, pieces,
                 "a closed sheet in tetrahedron " + std::to_string(c.input.cells[tet])))
      return;
  if (open.empty()) return ledger.certify();
  ledger.leave_open("orientation of " + open, why_open);
}

}  // namespace certificate
