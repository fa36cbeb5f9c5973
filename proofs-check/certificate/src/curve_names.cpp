// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curve_names.hpp"

#include <algorithm>
#include <cmath>

namespace certificate {
namespace {

using Point = std::array<double, 3>;

/// Where a point of a face's refinement lies in space, roughly.
Point place_of(const LevelCase& c, const FaceTopology& face, Refinement::Id id) {
  std::array<double, 3> mantissa{};
  std::array<long, 3> exponent{};
  long largest = -1000000;
  for (std::size_t i = 0; i < 3; ++i) {
    mantissa[i] = mpz_get_d_2exp(&exponent[i],
                                 face.level.refinement->points()[id].weights[i].get_mpz_t());
    exponent[i] -= c.field.exponent(face.vertices[i]);  // weights are those of integer tensors
    if (mantissa[i] != 0) largest = std::max(largest, exponent[i]);
  }
  Point sum{};
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
                         const Point& from) {
  double best = HUGE_VAL;
  for (const auto& [a, b] : face.level.loops[curve]) {
    const Point p = place_of(c, face, a), q = place_of(c, face, b);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += std::pow((p[k] + q[k]) / 2 - from[k], 2);
    best = std::min(best, square);
  }
  return best;
}

}  // namespace

const FaceTopology& face_opposite(const LevelCase& c, std::size_t tet, Vertex opposite) {
  std::array<Vertex, 3> face{};
  std::size_t n = 0;
  for (const Vertex v : c.input.tets[tet])
    if (v != opposite && n < 3) face[n++] = v;
  return *c.topology.face(face);
}

std::vector<Number> curve_names(const LevelCase& c, const FaceTopology& face) {
  const std::size_t count = face.level.loops.size();
  const Json numbers = face.vertices, &faces = c.claims["faces"];
  const auto claim = std::lower_bound(faces.begin(), faces.end(), numbers,
                                      [](const Json& f, const Json& n) {
                                        return std::array{f[0], f[1], f[2]} <
                                               std::array{n[0], n[1], n[2]};
                                      });
  if (claim == faces.end() || (*claim)[4].size() != count ||
      Json::array({(*claim)[0], (*claim)[1], (*claim)[2]}) != numbers)
    return {};
  std::map<std::size_t, Number> names;
  for (const Json& v : (*claim)[4]) {
    const Number vertex = v.get<Number>();
    if (vertex >= c.surface.points.size()) return {};
    std::vector<double> distances;
    for (std::size_t i = 0; i < count && count > 1; ++i)
      distances.push_back(distance_to_curve(c, face, i, c.surface.points[vertex]));
    names[static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) -
                                   distances.begin())] = vertex;
  }
  std::vector<Number> result;
  for (const auto& [curve, name] : names) result.push_back(name);
  return names.size() == count ? result : std::vector<Number>{};
}

}  // namespace certificate
