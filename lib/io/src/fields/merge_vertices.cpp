// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "fields/merge_points.hpp"
#include "fields/solid_cells.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Tensor = SymmetricTensor<double>;

/// What decides which vertices in the same place become one.
struct Groups {
  const TetMesh& mesh;
  bool by_tensor;                                    ///< equal ones only
  std::vector<std::vector<std::size_t>> materials;  ///< around each vertex, ascending; or none

  bool place_less(std::size_t a, std::size_t b) const {
    const auto &p = mesh.points[a], &q = mesh.points[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    return p.z < q.z;
  }
  bool belong_together(std::size_t a, std::size_t b) const {
    return (!by_tensor || mesh.tensors[a] == mesh.tensors[b]) &&
           (materials.empty() || materials[a] == materials[b]);
  }
};

/// For each vertex the first of those that it becomes one with.
std::vector<std::size_t> first_of_group(const Groups& groups) {
  const std::size_t n = groups.mesh.points.size();
  std::vector<std::size_t> order(n), first(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return groups.place_less(a, b); });
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    std::vector<std::size_t> firsts;  // of the groups in this place
    for (end = begin; end < n && !groups.place_less(order[begin], order[end]); ++end) {
      const std::size_t v = order[end];
      const auto found = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t f) {
        return groups.belong_together(f, v);
      });
      if (found == firsts.end())
        firsts.push_back(v);
      else
        first[v] = *found;
    }
  }
  return first;
}

}  // namespace

std::size_t merge_vertices(const std::vector<RawGrid>& pieces, VertexMap& map,
                           const std::vector<std::vector<std::size_t>>& materials,
                           std::optional<MeanWeights> mean, TetMesh& mesh) {
  const std::size_t n = mesh.points.size();
  const bool has_tensors = !mesh.tensors.empty();
  Groups groups{mesh, has_tensors && !mean, {}};
  std::vector<double> weight(n, mean == MeanWeights::volume ? 0 : 1);
  if (!materials.empty()) groups.materials.resize(n);
  for (std::size_t k = 0; mean && k < pieces.size(); ++k)
    for (const std::size_t c : solid_cells(pieces[k])) {
      const std::vector<Index> nodes = vertices_of(pieces[k], c, map[k]);
      const double volume = *mean == MeanWeights::volume
                                ? cell_volume(mesh, pieces[k].types[c], nodes)
                                : 0;
      for (const Index v : nodes) {
        weight[as_size(v)] += volume;
        if (!materials.empty()) groups.materials[as_size(v)].push_back(materials[k][c]);
      }
    }
  for (auto& list : groups.materials) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  const std::vector<std::size_t> first = first_of_group(groups);
  if (has_tensors && mean) {
    std::vector<Tensor> sum(n);
    std::vector<double> sums(n, 0);
    std::vector<std::size_t> size(n, 0);
    for (std::size_t v = 0; v < n; ++v) {
      sum[first[v]] = sum[first[v]] + weight[v] * mesh.tensors[v];
      sums[first[v]] += weight[v];
      ++size[first[v]];
    }
    for (std::size_t v = 0; v < n; ++v) {
      if (first[v] != v || size[v] < 2 || sums[v] == 0) continue;
      const Tensor& t = sum[v];
      const double w = sums[v];
      mesh.tensors[v] = {t.xx / w, t.yy / w, t.zz / w, t.xy / w, t.yz / w, t.xz / w};
      for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz})
        if (!std::isfinite(x))
          throw IoError(IoError::Kind::invalid, pieces.front().file,
                        "the tensors in one place are too large to average (point " +
                            std::to_string(v) + ")");
    }
  }
  std::vector<Index> number(n);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < n; ++v) {
    if (first[v] != v) {
      number[v] = number[first[v]];  // the first has the smallest number
      continue;
    }
    number[v] = static_cast<Index>(kept);
    mesh.points[kept] = mesh.points[v];
    if (has_tensors) mesh.tensors[kept] = mesh.tensors[v];
    ++kept;
  }
  mesh.points.resize(kept);
  if (has_tensors) mesh.tensors.resize(kept);
  for (auto& of_piece : map)
    for (Index& v : of_piece) v = number[as_size(v)];
  return n - kept;
}

}  // namespace tensortopo::detail
