// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curve_names.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {
namespace {

using Place = std::array<double, 3>;

/// Where a point of a face's refinement lies in space, roughly.
Place place_of(const LevelCase& c, const FaceTopology& face, Refinement::Id id) {
  std::array<double, 3> mantissa{};
  std::array<long, 3> exponent{};
  long largest = -1000000;
  for (std::size_t i = 0; i < 3; ++i) {
    mantissa[i] = mpz_get_d_2exp(&exponent[i],
                                 face.level.refinement->points()[id].weights[i].get_mpz_t());
    exponent[i] -= c.field.exponent(face.vertices[i]);  // weights are those of integer tensors
    if (mantissa[i] != 0) largest = std::max(largest, exponent[i]);
  }
  Place sum{};
  double total = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double w = std::ldexp(
        mantissa[i], static_cast<int>(std::max(exponent[i] - largest, -1000L)));
    total += w;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += w * c.input.points[face.vertices[i]][k];
  }
  for (double& x : sum) x /= total;
  return sum;
}

double distance_to_curve(const LevelCase& c, const FaceTopology& face, std::size_t curve,
                         const Place& from) {
  double best = HUGE_VAL;
  for (const auto& [a, b] : face.level.loops[curve]) {
    const Place p = place_of(c, face, a), q = place_of(c, face, b);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += std::pow((p[k] + q[k]) / 2 - from[k], 2);
    best = std::min(best, square);
  }
  return best;
}

}  // namespace

std::vector<Number> curve_names(const LevelCase& c, const TetTopology& tet, Vertex opposite) {
  const auto& vertices = c.input.tets[tet.tet];
  const auto at = std::find(vertices.begin(), vertices.end(), opposite) - vertices.begin();
  const FaceTopology* face = c.topology.face(face_of(vertices, static_cast<std::size_t>(at)));
  const std::array<Number, 3> numbers{face->vertices[0], face->vertices[1], face->vertices[2]};
  const auto place = std::lower_bound(c.claims.faces.begin(), c.claims.faces.end(), numbers,
                                      [](const FaceClaim& f, const auto& n) { return f.face < n; });
  if (place == c.claims.faces.end() || place->face != numbers ||
      place->loops.size() != face->level.loops.size())
    return {};
  if (face->level.loops.size() == 1) return place->loops;
  std::map<std::size_t, Number> names;
  for (const Number v : place->loops) {
    if (v >= c.surface.points.size()) return {};
    std::vector<double> distances;
    for (std::size_t i = 0; i < face->level.loops.size(); ++i)
      distances.push_back(distance_to_curve(c, *face, i, c.surface.points[v]));
    names[static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) -
                                   distances.begin())] = v;
  }
  std::vector<Number> result;
  for (const auto& [curve, name] : names) result.push_back(name);
  return names.size() == face->level.loops.size() ? result : std::vector<Number>{};
}

}  // namespace certificate
