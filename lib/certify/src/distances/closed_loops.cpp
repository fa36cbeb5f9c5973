// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/closed_loops.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tensortopo {

namespace {

using Vertex = SurfaceMesh::Index;

/// A sheet that meets no edge of its tetrahedron, by a vertex on each of its loops.
struct ClosedSheet {
  TetMesh::Index tet;
  std::vector<Vertex> loops;
};

std::vector<ClosedSheet> closed_sheets(const SurfaceMesh& surface, const LevelTopology& topology) {
  std::vector<ClosedSheet> result;
  for (const auto& tet : topology.tets)
    for (const auto& sheet : tet.sheets) {
      ClosedSheet found{tet.tet, {}};
      for (const auto& loop : sheet.loops) found.loops.push_back(loop[0].from);
      if (std::none_of(found.loops.begin(), found.loops.end(),
                       [&](Vertex v) { return surface.carrier[as_size(v)] == Carrier::edge; }))
        result.push_back(std::move(found));
    }
  for (const auto& cone : topology.cones)
    for (const auto& sheet : cone.sheets)
      if (sheet.size() == 2) result.push_back({cone.tet, {sheet[0]}});
  return result;
}

/// The boundary loops of one tetrahedron's triangles: from each vertex the next.
std::map<Vertex, Vertex> boundary_loops_of(const SurfaceMesh& surface,
                                           const std::vector<std::size_t>& triangles) {
  std::set<std::array<Vertex, 2>> open;
  for (const auto i : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v = surface.triangles[i][k], w = surface.triangles[i][(k + 1) % 3];
      if (open.erase({w, v}) == 0) open.insert({v, w});
    }
  std::map<Vertex, Vertex> next;
  for (const auto& [v, w] : open) next[v] = w;
  return next;
}

double distance_to_segment(const Vector3<double>& x, const Vector3<double>& p,
                           const Vector3<double>& q) {
  const auto d = q - p;
  const double t = std::clamp(dot(x - p, d) / dot(d, d), 0.0, 1.0);
  const auto e = x - (p + t * d);
  return length(e);
}

/// Whether a polygon winds once around its mean, at more than twice its reaches from it. So far
/// away rounding does not change the winding number.
bool winds_once(const SurfaceMesh& surface, const std::vector<Vertex>& polygon,
                std::span<const int> reach) {
  const auto at = [&](std::size_t k) { return surface.points[as_size(polygon[k])]; };
  const std::size_t n = polygon.size();
  Vector3<double> centre{};
  double longest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    centre += (1.0 / static_cast<double>(n)) * at(k);
    longest = std::max(longest, reach_length(reach[as_size(polygon[k])]));
  }
  Vector3<double> normal{};
  for (std::size_t k = 0; k < n; ++k) {
    if (!(distance_to_segment(centre, at(k), at((k + 1) % n)) > 2 * longest)) return false;
    normal += cross(at(k) - centre, at((k + 1) % n) - centre);
  }
  // Seen along the axis that the normal is closest to.
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const auto flat = [&](const Vector3<double>& p) -> std::array<double, 2> {
    const auto d = p - centre;
    if (x >= y && x >= z) return {d.y, d.z};
    if (y >= z) return {d.z, d.x};
    return {d.x, d.y};
  };
  int winding = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const auto p = flat(at(k)), q = flat(at((k + 1) % n));
    const bool from = p[1] > 0, to = q[1] > 0;
    if (from == to) continue;
    const double side = p[0] * q[1] - p[1] * q[0];
    if (to && side > 0) ++winding;
    if (from && side < 0) --winding;
  }
  return winding == 1 || winding == -1;
}

}  // namespace

std::vector<TetMesh::Index> uncovered_closed_loops(const SurfaceMesh& surface,
                                                   std::span<const std::size_t> triangles,
                                                   const LevelTopology& topology,
                                                   std::span<const int> reach) {
  const std::vector<ClosedSheet> sheets = closed_sheets(surface, topology);
  std::map<TetMesh::Index, std::vector<std::size_t>> of_tet;
  for (const auto& sheet : sheets) of_tet[sheet.tet];
  for (const auto i : triangles)
    if (const auto found = of_tet.find(surface.tet[i]); found != of_tet.end())
      found->second.push_back(i);
  std::map<TetMesh::Index, std::map<Vertex, Vertex>> loops;
  for (const auto& [tet, members] : of_tet) loops[tet] = boundary_loops_of(surface, members);

  std::set<TetMesh::Index> result;
  for (const auto& sheet : sheets) {
    const auto& next = loops[sheet.tet];
    const bool is_covered = std::any_of(sheet.loops.begin(), sheet.loops.end(), [&](Vertex from) {
      std::vector<Vertex> polygon;
      Vertex v = from;
      do {
        polygon.push_back(v);
        const auto after = next.find(v);
        if (after == next.end() || polygon.size() > next.size()) return false;
        v = after->second;
      } while (v != from);
      return winds_once(surface, polygon, reach);
    });
    if (!is_covered) result.insert(sheet.tet);
  }
  return {result.begin(), result.end()};
}

}  // namespace tensortopo
