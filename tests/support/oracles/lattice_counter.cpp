// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "lattice_counter.hpp"

#include <algorithm>
#include <bit>
#include <map>

namespace tensortopo::test {

namespace {

constexpr int free_slot = -1;

std::size_t slot_of(std::uint32_t key, std::size_t capacity) {
  const std::uint64_t mixed = std::uint64_t{key} * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(mixed >> 32) & (capacity - 1);
}

}  // namespace

PolygonCounter::PolygonCounter(std::size_t expected_vertices)
    : table_(std::bit_ceil(2 * expected_vertices + 16), {0, free_slot}) {}

int PolygonCounter::vertex(std::uint32_t key) {
  std::size_t slot = slot_of(key, table_.size());
  while (table_[slot].second != free_slot) {
    if (table_[slot].first == key) return table_[slot].second;
    slot = (slot + 1) & (table_.size() - 1);
  }
  const int id = surface_.add();
  boundary_.add();
  tally_.emplace_back();
  on_boundary_.push_back(0);
  table_[slot] = {key, id};
  if (2 * tally_.size() > table_.size()) grow();
  return id;
}

void PolygonCounter::grow() {
  std::vector<std::pair<std::uint32_t, int>> larger(2 * table_.size(), {0, free_slot});
  for (const auto& entry : table_) {
    if (entry.second == free_slot) continue;
    std::size_t slot = slot_of(entry.first, larger.size());
    while (larger[slot].second != free_slot) slot = (slot + 1) & (larger.size() - 1);
    larger[slot] = entry;
  }
  table_.swap(larger);
}

void PolygonCounter::add_polygon(const int* vertices, int count) {
  for (int i = 1; i < count; ++i) surface_.unite(vertices[0], vertices[i]);
  Tally& tally = tally_[static_cast<std::size_t>(vertices[0])];
  tally.polygons += 1;
  tally.sides += count;
}

void PolygonCounter::add_boundary_segment(int u, int v) {
  boundary_.unite(u, v);
  on_boundary_[static_cast<std::size_t>(u)] = on_boundary_[static_cast<std::size_t>(v)] = 1;
  tally_[static_cast<std::size_t>(u)].boundary_segments += 1;
}

std::vector<ComponentTopology> PolygonCounter::components() {
  struct Sum {
    int vertices = 0, polygons = 0, half_edges = 0, loops = 0;
  };
  std::map<int, Sum> sums;
  for (int v = 0; v < surface_.size(); ++v) {
    Sum& sum = sums[surface_.find(v)];
    const Tally& tally = tally_[static_cast<std::size_t>(v)];
    sum.vertices += 1;
    sum.polygons += tally.polygons;
    sum.half_edges += tally.sides + tally.boundary_segments;
    sum.loops += on_boundary_[static_cast<std::size_t>(v)] != 0 && boundary_.find(v) == v;
  }
  std::vector<ComponentTopology> result;
  for (const auto& [root, sum] : sums) {
    result.push_back({sum.vertices - sum.half_edges / 2 + sum.polygons, sum.loops});
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tensortopo::test
