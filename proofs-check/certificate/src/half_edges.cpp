// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "half_edges.hpp"

#include <map>
#include <set>

#include "union_find.hpp"

namespace certificate {
namespace {

std::uint64_t directed(std::uint32_t from, std::uint32_t to) {
  return static_cast<std::uint64_t>(from) << 32 | to;
}

}  // namespace

HalfEdges::HalfEdges(std::span<const Triangle> triangles) : triangles_(triangles) {
  by_edge_.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      by_edge_.emplace(directed(triangles[t][i], triangles[t][(i + 1) % 3]), t);
}

std::size_t HalfEdges::across(std::size_t t, std::size_t i) const {
  const auto place = by_edge_.find(directed(triangles_[t][(i + 1) % 3], triangles_[t][i]));
  return place == by_edge_.end() ? kNone : place->second;
}

std::string HalfEdges::defect() const {
  if (by_edge_.size() != 3 * triangles_.size())
    return "an edge that two triangles run along in the same direction";
  // Corners of one vertex that a common edge joins are in one fan.
  UnionFind fans(3 * triangles_.size());
  std::map<std::uint32_t, std::size_t> fan_of;
  const auto corner_at = [&](std::size_t t, std::uint32_t vertex) {
    std::size_t i = 0;
    while (triangles_[t][i] != vertex) ++i;
    return 3 * t + i;
  };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = across(t, i);
      if (other == kNone) continue;
      for (const std::size_t end : {i, (i + 1) % 3})
        fans.join(3 * t + end, corner_at(other, triangles_[t][end]));
    }
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangles_[t][i];
      const std::size_t fan = fans.find(3 * t + i);
      if (fan_of.emplace(v, fan).first->second != fan)
        return "more than one fan of triangles around vertex " + std::to_string(v);
    }
  }
  return {};
}

std::vector<ComponentClaim> HalfEdges::components() const {
  std::map<std::uint32_t, std::size_t> number;  // of each vertex
  for (const Triangle& triangle : triangles_)
    for (const std::uint32_t v : triangle) number.emplace(v, 0);
  std::size_t count = 0;
  for (auto& [v, n] : number) n = count++;
  UnionFind parts(count), loops(count);
  for (const Triangle& t : triangles_)
    for (const std::uint32_t v : t) parts.join(number[t[0]], number[v]);
  std::map<std::size_t, ComponentClaim> found;  // by the smallest vertex
  std::set<std::size_t> on_boundary;
  for (const auto& [v, n] : number) {
    ComponentClaim& part = found[parts.find(n)];
    if (part.euler_characteristic++ == 0) part.first_vertex = v;
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    ComponentClaim& part = found[parts.find(number[triangles_[t][0]])];
    ++part.triangles;
    ++part.euler_characteristic;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = across(t, i);
      if (other == kNone || other > t) --part.euler_characteristic;
      if (other != kNone) continue;
      const std::size_t a = number[triangles_[t][i]], b = number[triangles_[t][(i + 1) % 3]];
      loops.join(a, b);
      on_boundary.insert({a, b});
    }
  }
  for (const std::size_t n : on_boundary)
    if (loops.find(n) == n) ++found[parts.find(n)].boundary_loops;
  std::vector<ComponentClaim> result;
  for (const auto& [n, part] : found) result.push_back(part);
  return result;
}

}  // namespace certificate
