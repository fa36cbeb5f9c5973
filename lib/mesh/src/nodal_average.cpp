// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/nodal_average.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {
namespace {

using Tensor = SymmetricTensor<double>;

Tensor divided(const Tensor& t, double n) {
  return {t.xx / n, t.yy / n, t.zz / n, t.xy / n, t.yz / n, t.xz / n};
}

/// Throws std::invalid_argument.
void require_counts(std::size_t node_count, const CellTensors& cells,
                    const NodalAverageOptions& options) {
  const auto require = [](bool holds, const char* text) {
    if (!holds) throw std::invalid_argument(text);
  };
  require(cells.nodes_per_cell > 0 && cells.nodes.size() % cells.nodes_per_cell == 0,
          "nodal average: a cell lacks nodes");
  const std::size_t count = cells.nodes.size() / cells.nodes_per_cell;
  require(cells.tensors_per_cell > 0 && cells.tensors.size() == count * cells.tensors_per_cell,
          "nodal average: as many tensors as cells need are expected");
  require(!cells.at_nodes || cells.tensors_per_cell == cells.nodes_per_cell,
          "nodal average: a tensor for each node of a cell is expected");
  require(options.weights.empty() || options.weights.size() == count,
          "nodal average: a weight for each cell is expected");
  require(options.materials.empty() || options.materials.size() == count,
          "nodal average: a material for each cell is expected");
  for (const double w : options.weights)
    require(w > 0, "nodal average: a weight is not positive");
  for (const TetMesh::Index v : cells.nodes)
    if (v < 0 || as_size(v) >= node_count)
      throw std::invalid_argument("nodal average: there is no node " + std::to_string(v));
}

/// Makes nodes between materials one for each.
void separate(std::size_t node_count, const CellTensors& cells,
              const std::vector<std::int64_t>& materials, NodalAverage& result) {
  std::vector<std::size_t> first_cell(node_count, SIZE_MAX);
  std::map<std::pair<TetMesh::Index, std::int64_t>, TetMesh::Index> added;
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    const std::size_t cell = i / cells.nodes_per_cell;
    TetMesh::Index& v = result.nodes[i];
    std::size_t& first = first_cell[as_size(v)];
    if (first == SIZE_MAX) first = cell;
    if (materials[first] == materials[cell]) continue;
    const auto next = static_cast<TetMesh::Index>(result.origin.size());
    const auto [found, is_new] = added.try_emplace({v, materials[cell]}, next);
    if (is_new) result.origin.push_back(v);
    v = found->second;
  }
}

}  // namespace

void NodalSums::add(std::span<const TetMesh::Index> nodes, std::span<const Tensor> tensors,
                    double weight) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(i), nodes[i]) !=
        nodes.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    const std::size_t v = as_size(nodes[i]);
    sums_[v] = sums_[v] + weight * tensors[tensors.size() == 1 ? 0 : i];
    weights_[v] += weight;
  }
}

std::vector<Tensor> NodalSums::means() const {
  std::vector<Tensor> result(sums_.size());
  for (std::size_t v = 0; v < sums_.size(); ++v)
    if (has(v)) result[v] = divided(sums_[v], weights_[v]);
  return result;
}

Tensor plain_mean(std::span<const Tensor> tensors) {
  Tensor sum{};
  for (const Tensor& t : tensors) sum = sum + t;
  return divided(sum, static_cast<double>(tensors.size()));
}

std::vector<double> tet_volumes(const TetMesh& mesh) {
  std::vector<double> volumes;
  volumes.reserve(mesh.tets.size());
  for (const auto& tet : mesh.tets) {
    const auto edge = [&](std::size_t k) {
      return mesh.points[as_size(tet[k])] - mesh.points[as_size(tet[0])];
    };
    volumes.push_back(dot(edge(1), cross(edge(2), edge(3))) / 6);
  }
  return volumes;
}

NodalAverage nodal_average(std::size_t node_count, const CellTensors& cells,
                           const NodalAverageOptions& options) {
  require_counts(node_count, cells, options);
  NodalAverage result;
  result.nodes = cells.nodes;
  for (std::size_t v = 0; v < node_count; ++v)
    result.origin.push_back(static_cast<TetMesh::Index>(v));
  if (!options.materials.empty()) separate(node_count, cells, options.materials, result);

  NodalSums sums(result.origin.size());
  const std::size_t count = cells.nodes.size() / cells.nodes_per_cell;
  const std::span<const TetMesh::Index> nodes(result.nodes);
  const std::span<const Tensor> tensors(cells.tensors);
  for (std::size_t c = 0; c < count; ++c) {
    const auto own = tensors.subspan(c * cells.tensors_per_cell, cells.tensors_per_cell);
    const double weight = options.weights.empty() ? 1 : options.weights[c];
    const auto around = nodes.subspan(c * cells.nodes_per_cell, cells.nodes_per_cell);
    if (cells.at_nodes) {
      sums.add(around, own, weight);
    } else {
      const Tensor mean = plain_mean(own);
      sums.add(around, {&mean, 1}, weight);
    }
  }
  result.tensors = sums.means();
  return result;
}

}  // namespace tensortopo
