// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_check.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tensortopo {

namespace {

/// A directed edge as one number, which sorts faster than two.
using Edge = std::uint64_t;

Edge edge(std::int32_t from, std::int32_t to) {
  return Edge{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
}
std::int32_t from(Edge e) { return static_cast<std::int32_t>(e >> 32); }
std::int32_t to(Edge e) { return static_cast<std::int32_t>(e & 0xffffffffu); }

/// Union-find over the places of vertices in a sorted list.
class Components {
 public:
  explicit Components(std::vector<std::int32_t> vertices) : vertices_(std::move(vertices)) {
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    parent_.resize(vertices_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t count() const { return vertices_.size(); }
  std::size_t of(std::int32_t v) {
    return root(static_cast<std::size_t>(
        std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin()));
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool has(std::int32_t v) const {
    return std::binary_search(vertices_.begin(), vertices_.end(), v);
  }
  void join(std::int32_t u, std::int32_t v) { parent_[of(u)] = of(v); }

 private:
  std::vector<std::int32_t> vertices_;
  std::vector<std::size_t> parent_;
};

/// The faces on which rim vertices lie.
class FacesOfVertices {
 public:
  explicit FacesOfVertices(std::span<const std::vector<RimVertex>> rims) {
    for (const auto& rim : rims)
      for (const auto& v : rim) faces_.emplace_back(v.id, v.faces);
    std::sort(faces_.begin(), faces_.end());
  }
  unsigned at(std::int32_t v) const {
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), std::pair{v, std::uint8_t{0}});
    return found != faces_.end() && found->first == v ? found->second : 0u;
  }

 private:
  std::vector<std::pair<std::int32_t, std::uint8_t>> faces_;
};

bool contains(const std::vector<Edge>& sorted, Edge e) {
  return std::binary_search(sorted.begin(), sorted.end(), e);
}

/// Sorts; false if an edge occurs twice.
bool sort_distinct(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

std::vector<Edge> edges_of(std::span<const std::vector<RimVertex>> rims) {
  std::vector<Edge> edges;
  for (const auto& rim : rims)
    for (std::size_t i = 0; i < rim.size(); ++i)
      edges.push_back(edge(rim[i].id, rim[(i + 1) % rim.size()].id));
  return edges;
}

}  // namespace

RimEdges::RimEdges(std::span<const std::vector<RimVertex>> rims) : edges_(edges_of(rims)) {
  std::sort(edges_.begin(), edges_.end());
}

bool RimEdges::contains(std::int32_t from, std::int32_t to) const {
  return tensortopo::contains(edges_, edge(from, to));
}

bool direct_as_planned(std::vector<std::array<std::int32_t, 3>>& triangles,
                       std::span<const std::vector<RimVertex>> rims,
                       std::span<const SheetTopology> sheets) {
  const RimEdges rim(rims);
  bool along = false, against = false;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      along |= rim.contains(t[i], t[(i + 1) % 3]);
      against |= rim.contains(t[(i + 1) % 3], t[i]);
    }
  if (along == against) return false;
  if (against)
    for (auto& t : triangles) std::swap(t[1], t[2]);
  return are_planned_sheets(triangles, rims, sheets);
}

bool are_planned_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                        std::span<const std::vector<RimVertex>> rims,
                        std::span<const SheetTopology> sheets) {
  std::vector<Edge> directed, rim_edges = edges_of(rims);
  std::vector<std::int32_t> vertices;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] == t[(i + 1) % 3]) return false;
      directed.push_back(edge(t[i], t[(i + 1) % 3]));
      vertices.push_back(t[i]);
    }
  if (!sort_distinct(directed) || !sort_distinct(rim_edges)) return false;
  for (const Edge e : rim_edges)
    if (!contains(directed, e) || contains(directed, edge(to(e), from(e)))) return false;

  const FacesOfVertices faces(rims);
  Components components(std::move(vertices));
  for (const Edge e : directed) components.join(from(e), to(e));
  std::vector<int> euler(components.count(), 0);
  for (std::size_t v = 0; v < components.count(); ++v) ++euler[components.root(v)];
  for (const auto& t : triangles) ++euler[components.of(t[0])];
  for (const Edge e : directed) {
    const auto a = from(e), b = to(e);
    const bool paired = contains(directed, edge(b, a));
    if (!paired && !contains(rim_edges, e)) return false;
    if (paired && (faces.at(a) & faces.at(b)) != 0) return false;
    if (!paired || a < b) --euler[components.of(a)];
  }
  std::size_t count = 0;
  for (std::size_t v = 0; v < components.count(); ++v)
    if (components.root(v) == v) ++count;
  if (count != sheets.size()) return false;
  std::vector<char> taken(components.count(), 0);
  for (const auto& sheet : sheets) {
    if (sheet.loops.empty()) return false;
    const auto first = rims[static_cast<std::size_t>(sheet.loops[0])][0].id;
    if (!components.has(first)) return false;
    const auto component = components.of(first);
    for (const int loop : sheet.loops)
      if (components.of(rims[static_cast<std::size_t>(loop)][0].id) != component) return false;
    if (taken[component]++ || euler[component] != sheet.euler_characteristic) return false;
  }
  return true;
}

}  // namespace tensortopo
