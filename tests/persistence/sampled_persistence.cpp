// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sampled_persistence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

std::vector<SampledPair> merge_pairs(const TetMesh& mesh, const std::vector<double>& value) {
  const std::size_t n = value.size();
  std::vector<std::vector<int>> neighbours(n);
  for (const auto& t : mesh.tets)
    for (const int v : t)
      for (const int w : t)
        if (v != w) neighbours[static_cast<std::size_t>(v)].push_back(w);
  std::vector<std::size_t> order(n), parent(n), rank(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  for (std::size_t i = 0; i < n; ++i) rank[order[i]] = i;
  // Each class is named by its oldest vertex.
  const auto find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<SampledPair> pairs;
  for (const std::size_t v : order)
    for (const int neighbour : neighbours[v]) {
      const auto w = static_cast<std::size_t>(neighbour);
      if (rank[w] > rank[v]) continue;
      auto a = find(v), b = find(w);
      if (a == b) continue;
      if (rank[a] > rank[b]) std::swap(a, b);
      if (value[b] > value[v]) pairs.push_back({value[b], value[v]});
      parent[b] = a;
    }
  pairs.push_back({value[order.front()], value[order.back()]});
  return pairs;
}

}  // namespace

SampledPersistence sampled_persistence(TetMesh mesh, int cuts) {
  for (int i = 0; i < cuts; ++i) mesh = subdivide(mesh);
  std::vector<double> value;
  std::vector<Deviator<double>> tensors;
  for (const auto& t : mesh.tensors) {
    tensors.push_back(deviator(t));
    value.push_back(std::numbers::pi / 6 - lode_angle(tensors.back()));
  }
  SampledPersistence result;
  for (const auto& t : mesh.tets)
    for (const int i : t)
      for (const int j : t) {
        if (i >= j) continue;
        const auto v = static_cast<std::size_t>(i), w = static_cast<std::size_t>(j);
        const double between = std::numbers::pi / 6 - lode_angle(tensors[v] + tensors[w]);
        result.error = std::max(result.error, 2 * std::abs(between - (value[v] + value[w]) / 2));
      }
  result.superlevel = merge_pairs(mesh, value);
  for (double& x : value) x = -x;
  result.sublevel = merge_pairs(mesh, value);
  return result;
}

int rank_between(const std::vector<SampledPair>& pairs, double a, double b) {
  return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [&](const SampledPair& p) {
    return p.birth >= a && p.death <= b;
  }));
}

}  // namespace tensortopo::test
