// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_check.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/union_find.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tensortopo {

namespace {

/// A directed edge as one number, which sorts faster than two.
using Edge = std::uint64_t;

Edge edge(std::int32_t from, std::int32_t to) {
  return Edge{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
}

std::vector<Edge> edges_of(std::span<const std::vector<BoundaryVertex>> boundaries) {
  std::vector<Edge> edges;
  for (const auto& boundary : boundaries)
    for (std::size_t i = 0; i < boundary.size(); ++i)
      edges.push_back(edge(boundary[i].id, boundary[(i + 1) % boundary.size()].id));
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Vertices by their places in a sorted list, joined to components.
class Vertices {
 public:
  Vertices(std::span<const std::array<std::int32_t, 3>> triangles,
           std::span<const std::vector<BoundaryVertex>> boundaries) {
    ids_.reserve(3 * triangles.size());
    for (const auto& t : triangles) ids_.insert(ids_.end(), t.begin(), t.end());
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    classes_ = UnionFind(ids_.size());
    faces_.resize(ids_.size(), 0);
    for (const auto& boundary : boundaries)
      for (const auto& v : boundary)
        if (has(v.id)) faces_[place(v.id)] = v.faces;
  }

  std::size_t count() const { return ids_.size(); }
  bool has(std::int32_t v) const { return std::binary_search(ids_.begin(), ids_.end(), v); }
  /// @pre has(v)
  std::uint32_t place(std::int32_t v) const {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), v) - ids_.begin());
  }
  std::int32_t id(std::uint32_t place) const { return ids_[place]; }
  /// The faces on which boundary loop vertices lie.
  unsigned faces(std::uint32_t place) const { return faces_[place]; }

  std::uint32_t root(std::uint32_t i) { return classes_.find(i); }
  void join(std::uint32_t u, std::uint32_t v) { classes_.unite(u, v); }

 private:
  std::vector<std::int32_t> ids_;
  UnionFind classes_;
  std::vector<std::uint8_t> faces_;
};

/// Edges of triangles, between places of vertices: each has one triangle, or two that run against
/// each other.
struct SheetEdges {
  std::vector<std::array<std::uint32_t, 2>> single, paired;
};

std::optional<SheetEdges> edges_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  // The smaller vertex first; the last bit tells whether it was the second.
  std::vector<Edge> uses;
  uses.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge a = t[i], b = t[(i + 1) % 3];
      if (a == b) return std::nullopt;
      uses.push_back(a < b ? a << 33 | b << 1 : b << 33 | a << 1 | 1);
    }
  std::sort(uses.begin(), uses.end());
  SheetEdges edges;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const auto low = static_cast<std::uint32_t>(uses[i] >> 33),
               high = static_cast<std::uint32_t>(uses[i] >> 1);
    const bool has_two = i + 1 < uses.size() && uses[i] >> 1 == uses[i + 1] >> 1;
    if (!has_two) {
      if (uses[i] & 1)
        edges.single.push_back({high, low});
      else
        edges.single.push_back({low, high});
      continue;
    }
    if (uses[i] == uses[i + 1]) return std::nullopt;
    if (i + 2 < uses.size() && uses[i] >> 1 == uses[i + 2] >> 1) return std::nullopt;
    edges.paired.push_back({low, high});
    ++i;
  }
  return edges;
}

/// 1 if triangles are the planned sheets, -1 if they are when turned around, else 0.
int direction_in_plan(std::span<const std::array<std::int32_t, 3>> triangles,
                      std::span<const std::vector<BoundaryVertex>> boundaries,
                      const Sheets& sheets) {
  Vertices vertices(triangles, boundaries);
  std::vector<std::array<std::uint32_t, 3>> places;
  places.reserve(triangles.size());
  for (const auto& t : triangles)
    places.push_back({vertices.place(t[0]), vertices.place(t[1]), vertices.place(t[2])});
  const auto edges = edges_of(places);
  if (!edges) return 0;
  const auto boundary_edges = edges_of(boundaries);
  const auto is_boundary = [&](std::size_t first) {
    std::vector<Edge> single;
    for (const auto& e : edges->single)
      single.push_back(edge(vertices.id(e[first]), vertices.id(e[1 - first])));
    std::sort(single.begin(), single.end());
    return single == boundary_edges;
  };
  const int direction = is_boundary(0) ? 1 : is_boundary(1) ? -1 : 0;
  if (direction == 0) return 0;

  for (const auto& t : places) vertices.join(t[0], t[1]), vertices.join(t[1], t[2]);
  std::vector<int> euler(vertices.count(), 0);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < vertices.count(); ++v) {
    ++euler[vertices.root(v)];
    if (vertices.root(v) == v) ++count;
  }
  for (const auto& t : places) ++euler[vertices.root(t[0])];
  for (const auto& e : edges->single) --euler[vertices.root(e[0])];
  for (const auto& e : edges->paired) {
    if ((vertices.faces(e[0]) & vertices.faces(e[1])) != 0) return 0;
    --euler[vertices.root(e[0])];
  }
  if (count != sheets.size()) return 0;
  std::vector<char> taken(vertices.count(), 0);
  for (const auto& sheet : sheets) {
    if (sheet.loops.empty()) return 0;
    const auto component_of = [&](int loop) {
      return vertices.root(vertices.place(boundaries[static_cast<std::size_t>(loop)][0].id));
    };
    const auto component = component_of(sheet.loops[0]);
    for (const int loop : sheet.loops)
      if (component_of(loop) != component) return 0;
    if (taken[component]++ || euler[component] != sheet.euler_characteristic) return 0;
  }
  return direction;
}

}  // namespace

BoundaryEdges::BoundaryEdges(std::span<const std::vector<BoundaryVertex>> boundaries)
    : edges_(edges_of(boundaries)) {}

bool BoundaryEdges::contains(std::int32_t from, std::int32_t to) const {
  return std::binary_search(edges_.begin(), edges_.end(), edge(from, to));
}

bool direct_as_proved(std::vector<std::array<std::int32_t, 3>>& triangles,
                      std::span<const std::vector<BoundaryVertex>> boundaries,
                      const Sheets& sheets) {
  const int direction = direction_in_plan(triangles, boundaries, sheets);
  if (direction < 0)
    for (auto& t : triangles) std::swap(t[1], t[2]);
  return direction != 0;
}

bool are_proved_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                       std::span<const std::vector<BoundaryVertex>> boundaries,
                       const Sheets& sheets) {
  return direction_in_plan(triangles, boundaries, sheets) > 0;
}

template <class Scalar>
void drop_unused_inner(Patch<Scalar>& meshed, std::size_t first_inner,
                       std::size_t first_triangle) {
  std::vector<std::int32_t> kept(meshed.inner.size() - first_inner, 0);
  const auto number = [&](std::int32_t corner) {
    return static_cast<std::size_t>(-1 - corner) - first_inner;
  };
  for (std::size_t i = first_triangle; i < meshed.triangles.size(); ++i)
    for (const auto corner : meshed.triangles[i])
      if (corner < 0) kept[number(corner)] = 1;
  auto count = first_inner;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (kept[k] == 0) continue;
    meshed.inner[count++] = meshed.inner[first_inner + k];
    kept[k] = -static_cast<std::int32_t>(count);
  }
  if (count == meshed.inner.size()) return;
  meshed.inner.resize(count);
  for (std::size_t i = first_triangle; i < meshed.triangles.size(); ++i)
    for (auto& corner : meshed.triangles[i])
      if (corner < 0) corner = kept[number(corner)];
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template void drop_unused_inner(Patch<Scalar>&, std::size_t, std::size_t);
TENSORTOPO_FOR_EACH_PRECISION(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
