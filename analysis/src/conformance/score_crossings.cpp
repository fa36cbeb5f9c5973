// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "conformance/score_parts.hpp"
#include "conformance/triangle_search.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

// A place on an edge, as a part of its length, and the component there.
struct Hit {
  double place = 0;
  Index component = -1;
  double low = 0, high = 0;  ///< the place, if all may be shifted by the touching distance
  auto operator<=>(const Hit&) const = default;
};

// Where the edge meets the triangle or passes it within `eps`.
bool meets(const Vector3<double>& p, const Vector3<double>& q, const Vector3<double>& a,
           const Vector3<double>& b, const Vector3<double>& c, double eps, Hit& hit) {
  const auto n = cross(b - a, c - a);
  const double from = dot(p - a, n), to = dot(q - a, n), size = length(n) * eps;
  if (from - to == 0 || std::min(from, to) > size || std::max(from, to) < -size) return false;
  hit.place = std::clamp(from / (from - to), 0.0, 1.0);
  // Where the edge is within `eps` of the plane, and beside the triangle.
  const double blur = size / std::abs(from - to), slack = eps / length(q - p);
  const auto along = [&](const Vector3<double>& x) {
    return dot(x - p, q - p) / dot(q - p, q - p);
  };
  const auto [first, last] = std::minmax({along(a), along(b), along(c)});
  hit.low = std::min(hit.place, std::max(hit.place - blur, first - slack));
  hit.high = std::max(hit.place, std::min(hit.place + blur, last + slack));
  return distance_to_triangle(p + hit.place * (q - p), a, b, c) <= eps;
}

// Hits closer than `width` are one.
std::vector<Hit> clustered(std::vector<Hit> hits, double width) {
  std::sort(hits.begin(), hits.end());
  std::vector<Hit> clusters;
  double last = -1;
  for (const Hit& hit : hits) {
    if (clusters.empty() || hit.place - last > width) clusters.push_back(hit);
    last = hit.place;
  }
  return clusters;
}

// How many there are if hits whose places overlap are one: a triangle nearly along the edge meets
// it in no certain place.
std::size_t count_blurred(std::vector<Hit> hits, double width) {
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.low < b.low; });
  std::size_t count = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (const Hit& hit : hits) {
    if (hit.low - last > width) ++count;
    last = std::max(last, hit.high);
  }
  return count;
}

}  // namespace

std::vector<ComponentCrossing> score_crossings(const TetMesh& mesh, const Standard& standard,
                                               const GivenSurface& given,
                                               const std::vector<Index>& truth_component,
                                               const std::vector<Index>& given_component,
                                               double touch, SurfaceScore& score) {
  // Certified crossings by edge, with the component of the triangles there.
  std::map<std::array<Index, 2>, std::vector<Hit>> truth;
  std::vector<Index> of_vertex(standard.surface.points.size(), -1);
  for (std::size_t i = 0; i < standard.surface.triangles.size(); ++i)
    for (const Index v : standard.surface.triangles[i]) of_vertex[as_size(v)] = truth_component[i];
  for (const auto& edge : standard.level.topology.edges) {
    const auto& p = mesh.points[as_size(edge.vertices[0])];
    const auto d = mesh.points[as_size(edge.vertices[1])] - p;
    for (const auto& crossing : edge.crossings) {
      const auto& x = standard.surface.points[as_size(crossing.vertex)];
      truth[edge.vertices].push_back(
          {dot(x - p, d) / dot(d, d), of_vertex[as_size(crossing.vertex)]});
    }
    score.crossings += edge.crossings.size();
  }
  std::vector<char> undecided(mesh.tets.size(), 0);
  for (const auto& cell : standard.level.undecided) undecided[as_size(cell.tet)] = 1;
  std::vector<Index> decided;
  for (std::size_t t = 0; t < undecided.size(); ++t)
    if (!undecided[t]) decided.push_back(static_cast<Index>(t));
  const TetComplex complex = tet_complex(mesh, decided);

  std::vector<ComponentCrossing> shared;
  std::optional<TriangleSearch> search;
  if (!given.surface.triangles.empty()) search.emplace(given.surface);
  const double floor = touch_distance(mesh, given, 0, touch);
  for (const auto& edge : complex.edges) {
    const auto &p = mesh.points[as_size(edge[0])], &q = mesh.points[as_size(edge[1])];
    const double length = std::sqrt(dot(q - p, q - p)), eps = std::max(floor, touch * length);
    std::vector<Hit> hits;
    if (search) {
      const Vector3<double> pad{eps, eps, eps};
      const Vector3<double> low{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
      const Vector3<double> high{std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
      for (const Index i : search->near_box(low - pad, high + pad)) {
        const auto& t = given.surface.triangles[as_size(i)];
        Hit hit{0, given_component[as_size(i)]};
        if (meets(p, q, given.surface.points[as_size(t[0])], given.surface.points[as_size(t[1])],
                  given.surface.points[as_size(t[2])], eps, hit))
          hits.push_back(hit);
      }
    }
    const auto known = truth.find(edge);
    std::vector<Hit> expected = known == truth.end() ? std::vector<Hit>{} : known->second;
    if (hits.empty() && expected.empty()) continue;
    // Triangles nearly along the edge blur the place; ten times the touching distance allows that.
    const double width = 10 * eps / length;
    const std::vector<Hit> found = clustered(hits, width);
    const auto at_end = [&](const Hit& h) { return h.place < width || h.place > 1 - width; };
    if (std::any_of(expected.begin(), expected.end(), at_end) ||
        std::any_of(found.begin(), found.end(), at_end) ||
        clustered(expected, 2 * width).size() != expected.size()) {
      ++score.unclear_edges;
      continue;
    }
    const int n = static_cast<int>(expected.size()), m = static_cast<int>(found.size());
    for (int i = 0; i < std::min(n, m); ++i)
      shared.push_back({expected[static_cast<std::size_t>(i)].component,
                        found[static_cast<std::size_t>(i)].component});
    if (n == m) continue;
    if (m > n && count_blurred(hits, width) == expected.size()) {
      ++score.unclear_edges;
      continue;
    }
    score.edges.push_back({edge, n, m});
    (n > m ? score.missed_crossings : score.extra_crossings) +=
        static_cast<std::size_t>(std::abs(n - m));
  }
  return shared;
}

}  // namespace tensortopo
