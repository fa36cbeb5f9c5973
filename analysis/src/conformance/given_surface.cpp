// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/given_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;
using Place = std::array<double, 3>;

// The mode of each triangle, if an array has one for each and they are not all the same.
std::vector<double> modes_of(const std::vector<std::array<Index, 3>>& triangles,
                             const SurfaceArray* modes) {
  std::vector<double> result;
  if (modes == nullptr || modes->components != 1) return result;
  for (const auto& t : triangles) {
    const double mode = modes->values[as_size(t[0])];
    if (modes->values[as_size(t[1])] != mode || modes->values[as_size(t[2])] != mode) return {};
    result.push_back(mode);
  }
  const bool several = std::any_of(result.begin(), result.end(),
                                   [&](double mode) { return mode != result.front(); });
  return several ? result : std::vector<double>{};
}

// Leaves the triangles of one mode, and the points that these use.
void keep_mode(ReadTriangles& read, const std::vector<double>& modes, double mode) {
  SurfaceMesh kept;
  std::vector<Index> number(read.surface.points.size(), -1);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] != mode && modes[i] != static_cast<double>(static_cast<float>(mode))) {
      ++read.other_modes;
      continue;
    }
    std::array<Index, 3> triangle = read.surface.triangles[i];
    for (Index& v : triangle) {
      Index& n = number[as_size(v)];
      if (n < 0) {
        n = static_cast<Index>(kept.points.size());
        kept.points.push_back(read.surface.points[as_size(v)]);
      }
      v = n;
    }
    kept.triangles.push_back(triangle);
  }
  read.surface = std::move(kept);
}

// Zeros of both signs are one place.
Place place_of(const Vector3<double>& p, double distance) {
  if (distance > 0)
    return {std::floor(p.x / distance) + 0.0, std::floor(p.y / distance) + 0.0,
            std::floor(p.z / distance) + 0.0};
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

std::size_t count_seams(const SurfaceMesh& raw, const std::vector<Index>& place) {
  // Vertices at one place that a triangle's edge joins are one; such triangles are no more.
  UnionFind joined(raw.points.size());
  const auto unsigned_of = [](Index v) { return static_cast<std::uint32_t>(v); };
  for (const auto& t : raw.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (place[as_size(t[i])] == place[as_size(t[(i + 1) % 3])])
        joined.unite(unsigned_of(t[i]), unsigned_of(t[(i + 1) % 3]));
  std::map<std::array<Index, 2>, int> uses;
  for (const auto& t : raw.triangles) {
    std::array<Index, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<Index>(joined.find(unsigned_of(t[i])));
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (std::size_t i = 0; i < 3; ++i)
      ++uses[{std::min(v[i], v[(i + 1) % 3]), std::max(v[i], v[(i + 1) % 3])}];
  }
  std::map<std::array<Index, 2>, std::size_t> at_place;
  for (const auto& [edge, count] : uses) {
    if (count != 1) continue;
    const Index a = place[as_size(edge[0])], b = place[as_size(edge[1])];
    if (a != b) ++at_place[{std::min(a, b), std::max(a, b)}];
  }
  std::size_t seams = 0;
  for (const auto& [edge, count] : at_place) seams += count > 1 ? count - 1 : 0;
  return seams;
}

}  // namespace

ReadTriangles read_triangles(const std::filesystem::path& file, const ModeValue& mode) {
  SurfaceFile given = read_surface_file(file);
  ReadTriangles read;
  read.surface.triangles = triangulated(given);
  read.surface.points = std::move(given.points);
  const auto modes = modes_of(read.surface.triangles, given.find_point_data("mode"));
  if (!modes.empty()) keep_mode(read, modes, mode.approx());
  return read;
}

GivenSurface merge_points(const SurfaceMesh& triangles, double distance, bool shares_vertices) {
  GivenSurface result;
  std::map<Place, Index> numbers;
  std::vector<Index> place(triangles.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    const auto& p = triangles.points[i];
    for (const double x : {p.x, p.y, p.z})
      if (static_cast<double>(static_cast<float>(x)) != x) result.is_single_precision = false;
    const auto [it, fresh] = numbers.try_emplace(place_of(p, distance),
                                                 static_cast<Index>(result.surface.points.size()));
    if (fresh) result.surface.points.push_back(p);
    place[i] = it->second;
  }
  result.merged_points = place.size() - result.surface.points.size();
  if (shares_vertices) result.seam_edges = count_seams(triangles, place);
  std::set<std::array<Index, 3>> seen;
  for (const auto& t : triangles.triangles) {
    const std::array<Index, 3> merged{place[as_size(t[0])], place[as_size(t[1])],
                                      place[as_size(t[2])]};
    auto key = merged;
    std::sort(key.begin(), key.end());
    if (key[0] == key[1] || key[1] == key[2] || !seen.insert(key).second)
      ++result.collapsed_triangles;
    else
      result.surface.triangles.push_back(merged);
  }
  return result;
}

}  // namespace tensortopo
