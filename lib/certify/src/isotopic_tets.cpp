// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotopic_tets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "extract/patch/patch_intersections.hpp"
#include "for_each.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Vector = Vector3<double>;

/// How far a vertex may be from the point that it stands for, in parts of the largest coordinate of
/// the tetrahedra around: sixteen times what a checker allows for rounding.
constexpr double kRounding = 0x1p-46;

/// A vector, and how far each of its coordinates may be off.
struct Enclosed {
  Vector value;
  double error = 0;
};

Enclosed minus(const Enclosed& a, const Enclosed& b) {
  return {a.value - b.value, 2 * (a.error + b.error)};
}
Enclosed cross(const Enclosed& a, const Enclosed& b) {
  const double u = max_norm(a.value), v = max_norm(b.value);
  return {cross(a.value, b.value),
          4 * (a.error * (v + b.error) + b.error * u + 0x1p-50 * u * v)};
}

bool is_on_side(const Vector& direction, std::span<const Enclosed> vectors) {
  const double sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  return std::all_of(vectors.begin(), vectors.end(), [&](const Enclosed& v) {
    return dot(direction, v.value) > 2 * sum * (v.error + 0x1p-50 * max_norm(v.value));
  });
}

/// Whether some direction is seen to have a positive product with all vectors. The one of the
/// largest least product with unit vectors is normal to a vertex, an edge or a triangle of their
/// hull.
bool have_common_side(std::span<const Enclosed> vectors) {
  std::array<Vector, 9> units;
  const std::size_t count = vectors.size();
  Vector sum{}, best{};
  for (std::size_t i = 0; i < count; ++i) sum += units[i] = unit(vectors[i].value);
  if (is_on_side(sum, vectors)) return true;
  double largest = 0;
  const auto consider = [&](const Vector& d) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, dot(d, units[i]));
    if (least > largest * length(d)) largest = least / length(d), best = d;
  };
  for (std::size_t i = 0; i < count; ++i) {
    consider(units[i]);
    for (std::size_t j = 0; j < i; ++j) {
      consider(units[i] + units[j]);
      for (std::size_t k = 0; k < j; ++k) {
        const Vector normal = cross(units[j] - units[i], units[k] - units[i]);
        consider(normal), consider(-normal);
      }
    }
  }
  return largest > 0 && is_on_side(best, vectors);
}

/// Whether two triangles meet in shared vertices only, wherever their corners are within their
/// errors: a plane parts them but for a shared vertex; with two of these they do not fold together.
bool are_apart(std::span<const Enclosed> points, PatchTriangle a, PatchTriangle b) {
  std::size_t shared = 0;  // moved to the front
  for (std::size_t i = 0; i < 3; ++i) {
    const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
    if (same == b.end()) continue;
    std::swap(b[shared], *same), std::swap(a[shared], a[i]);
    ++shared;
  }
  const auto from = [&](std::uint32_t p, std::uint32_t q) { return minus(points[q], points[p]); };
  if (shared == 0) {
    std::array<Enclosed, 9> all;
    for (std::size_t i = 0; i < 9; ++i) all[i] = from(b[i % 3], a[i / 3]);
    return have_common_side(all);
  }
  if (shared == 1)
    return have_common_side(
        std::array{from(a[0], a[1]), from(a[0], a[2]), from(b[1], b[0]), from(b[2], b[0])});
  if (shared == 3) return false;
  const Enclosed edge = from(a[0], a[1]);
  return have_common_side(
      std::array{cross(edge, from(a[0], a[2])), cross(from(a[0], b[2]), edge)});
}

std::array<Index, 3> face_opposite(std::array<Index, 4> tet, std::size_t corner) {
  std::sort(tet.begin(), tet.end());
  std::array<Index, 3> face{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != corner) face[n++] = tet[i];
  return face;
}

/// By the topology alone: tetrahedra whose sheets are discs, and curves of faces told apart by their
/// ends.
std::vector<char> are_of_discs(const TetMesh& mesh, const LevelTopology& topology) {
  std::set<std::array<Index, 3>> mixed;
  for (const auto& face : topology.faces)
    if (face.loops.size() > 1 || (face.loops.size() == 1 && !face.arcs.empty()))
      mixed.insert(face.vertices);
  std::vector<char> result(mesh.tets.size(), 0);
  for (const auto& tet : topology.tets) {
    bool is_simple =
        std::all_of(tet.sheets.begin(), tet.sheets.end(), [](const LevelTopology::Sheet& sheet) {
          return sheet.euler_characteristic == 1 && sheet.loops.size() == 1;
        });
    for (std::size_t i = 0; i < 4 && !mixed.empty(); ++i)
      is_simple = is_simple && !mixed.contains(face_opposite(mesh.tets[as_size(tet.tet)], i));
    result[as_size(tet.tet)] = is_simple;
  }
  return result;
}

}  // namespace

std::vector<Index> tets_not_isotopic(const TetMesh& mesh, const SurfaceMesh& surface,
                                     std::span<const std::size_t> triangles,
                                     const LevelTopology& topology) {
  auto is_shown = are_of_discs(mesh, topology);
  std::vector<Enclosed> points(surface.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v].value = surface.points[v];
  for (const auto t : triangles) {
    double largest = 0;
    for (const Index corner : mesh.tets[as_size(surface.tet[t])])
      largest = std::max(largest, max_norm(mesh.points[as_size(corner)]));
    for (const auto v : surface.triangles[t])
      points[as_size(v)].error = std::max(points[as_size(v)].error, kRounding * largest);
  }
  std::vector<char> is_misplaced(points.size(), 0);
  for (const auto& [vertex, copy] : topology.copies)
    is_misplaced[as_size(vertex)] = is_misplaced[as_size(copy)] = 1;
  for (const auto& edge : topology.edges)
    for (std::size_t k = 1; k < edge.crossings.size(); ++k) {
      const auto v = as_size(edge.crossings[k - 1].vertex), w = as_size(edge.crossings[k].vertex);
      const auto along =
          mesh.points[as_size(edge.vertices[1])] - mesh.points[as_size(edge.vertices[0])];
      if (!is_on_side(along, std::array{minus(points[w], points[v])}))
        is_misplaced[v] = is_misplaced[w] = 1;
    }
  for (const auto t : triangles)
    for (const auto v : surface.triangles[t])
      if (is_misplaced[as_size(v)]) is_shown[as_size(surface.tet[t])] = 0;

  std::vector<PatchTriangle> asked;
  std::vector<Index> tets;
  std::vector<AxisBox> boxes;
  for (const auto t : triangles) {
    if (!is_shown[as_size(surface.tet[t])]) continue;
    tets.push_back(surface.tet[t]);
    auto& triangle = asked.emplace_back();
    auto& box = boxes.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = points[triangle[i] = static_cast<std::uint32_t>(surface.triangles[t][i])];
      const double around = 2 * p.error;
      const std::array<double, 3> x{p.value.x, p.value.y, p.value.z};
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = i == 0 ? x[k] - around : std::min(box.low[k], x[k] - around);
        box.high[k] = i == 0 ? x[k] + around : std::max(box.high[k], x[k] + around);
      }
    }
  }
  const auto pairs = meeting_boxes(boxes);
  std::vector<char> is_apart(pairs.size()), has_area(asked.size());
  detail::for_each(pairs.size(), [&](std::size_t i) {
    is_apart[i] = are_apart(points, asked[pairs[i][0]], asked[pairs[i][1]]);
  });
  detail::for_each(asked.size(), [&](std::size_t i) {
    const auto& [a, b, c] = asked[i];
    has_area[i] = have_common_side(
        std::array{cross(minus(points[b], points[a]), minus(points[c], points[a]))});
  });
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const auto t : pairs[i])
      if (!is_apart[i]) is_shown[as_size(tets[t])] = 0;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (!has_area[i]) is_shown[as_size(tets[i])] = 0;
  std::vector<Index> result;
  for (const auto t : triangles)
    if (!is_shown[as_size(surface.tet[t])]) result.push_back(surface.tet[t]);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace tensortopo
