// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "support/fields/random_fields.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/nodal_average.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
using Index = TetMesh::Index;

/// The tetrahedra of a cube's mesh with random tensors in them.
CellTensors random_cells(const TetMesh& mesh, std::size_t per_cell, bool at_nodes, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  CellTensors cells;
  for (const auto& tet : mesh.tets) cells.nodes.insert(cells.nodes.end(), tet.begin(), tet.end());
  cells.tensors_per_cell = per_cell;
  cells.at_nodes = at_nodes;
  for (std::size_t i = 0; i < per_cell * mesh.tets.size(); ++i)
    cells.tensors.push_back({normal(random), normal(random), normal(random), normal(random),
                             normal(random), normal(random)});
  return cells;
}

/// Cells on both sides of the middle.
std::vector<std::int64_t> halves(const TetMesh& mesh) {
  std::vector<std::int64_t> result;
  for (const auto& tet : mesh.tets) {
    double x = 0;
    for (const Index v : tet) x += mesh.points[as_size(v)].x;
    result.push_back(x < 4 ? 7 : -3);  // the cube is [0, 2]^3
  }
  return result;
}

double distance(const Tensor& s, const Tensor& t) { return std::sqrt(inner(s - t, s - t)); }

TEST(NodalAverage, IsTheWeightedMeanOfTheCellsAround) {
  const TetMesh mesh = cube_mesh(2);
  std::size_t compared = 0;
  for (const bool by_volume : {false, true})
    for (const bool at_nodes : {false, true}) {
      const CellTensors cells = random_cells(mesh, at_nodes ? 4 : 3, at_nodes, 1);
      NodalAverageOptions options;
      if (by_volume) {
        options.weights = tet_volumes(mesh);
        // Other weights than those of equal cells.
        for (std::size_t c = 0; c < options.weights.size(); ++c)
          options.weights[c] *= 1 + static_cast<double>(c % 5);
      }
      const auto average = nodal_average(mesh.points.size(), cells, options);
      ASSERT_EQ(average.tensors.size(), mesh.points.size());
      EXPECT_EQ(average.nodes, cells.nodes);
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        Tensor sum{};
        double weights = 0;
        for (std::size_t c = 0; c < mesh.tets.size(); ++c)
          for (std::size_t k = 0; k < 4; ++k) {
            if (as_size(mesh.tets[c][k]) != v) continue;
            const Tensor* own = cells.tensors.data() + c * cells.tensors_per_cell;
            const Tensor t = at_nodes ? own[k] : (1.0 / 3) * (own[0] + own[1] + own[2]);
            const double w = by_volume ? options.weights[c] : 1;
            sum = sum + w * t;
            weights += w;
          }
        EXPECT_LT(distance((1 / weights) * sum, average.tensors[v]), 1e-14);
        ++compared;
      }
    }
  EXPECT_EQ(compared, 4 * mesh.points.size());
}

TEST(NodalAverage, OfOneMaterialDoesNotDependOnTheOthers) {
  const TetMesh mesh = cube_mesh(2);
  NodalAverageOptions options;
  options.materials = halves(mesh);
  CellTensors cells = random_cells(mesh, 1, false, 2);
  const auto before = nodal_average(mesh.points.size(), cells, options);
  for (std::size_t c = 0; c < mesh.tets.size(); ++c)
    if (options.materials[c] == 7) cells.tensors[c] = 100.0 * cells.tensors[c];
  const auto after = nodal_average(mesh.points.size(), cells, options);
  ASSERT_EQ(before.nodes, after.nodes);
  EXPECT_EQ(before.origin.size(), mesh.points.size() + 9);  // the square between is doubled
  std::size_t same = 0, others = 0;
  for (std::size_t i = 0; i < before.nodes.size(); ++i) {
    const std::size_t v = as_size(before.nodes[i]);
    EXPECT_EQ(before.origin[v], cells.nodes[i]);
    if (options.materials[i / 4] == 7) {
      others += before.tensors[v] != after.tensors[v];
    } else {
      EXPECT_EQ(before.tensors[v], after.tensors[v]);
      ++same;
    }
  }
  EXPECT_EQ(same, others);
  EXPECT_EQ(same + others, before.nodes.size());
}

TEST(NodalAverage, OfAConstantIsTheConstantAndNothingWhereNoCellIs) {
  const TetMesh mesh = cube_mesh(1);
  CellTensors cells = random_cells(mesh, 4, true, 3);
  const Tensor constant{1, 2, 4, -8, 0.5, 16};
  for (Tensor& t : cells.tensors) t = constant;
  const auto average = nodal_average(mesh.points.size() + 1, cells);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_LT(distance(average.tensors[v], constant), 1e-14);
  EXPECT_EQ(average.tensors.back(), Tensor{});
}

TEST(NodalAverage, RefusesListsOfOtherLengths) {
  const TetMesh mesh = cube_mesh(1);
  const CellTensors good = random_cells(mesh, 1, false, 4);
  const std::size_t n = mesh.points.size();
  const auto refused = [&](auto&& change) {
    CellTensors cells = good;
    NodalAverageOptions options;
    std::size_t nodes = n;
    change(cells, options, nodes);
    EXPECT_THROW(nodal_average(nodes, cells, options), std::invalid_argument);
  };
  refused([](auto& cells, auto&, auto&) { cells.nodes.pop_back(); });
  refused([](auto& cells, auto&, auto&) { cells.tensors.pop_back(); });
  refused([](auto& cells, auto&, auto&) { cells.at_nodes = true; });
  refused([](auto&, auto& options, auto&) { options.weights = {1}; });
  refused([](auto& cells, auto& options, auto&) {
    options.weights.assign(cells.tensors.size(), 0);
  });
  refused([](auto&, auto& options, auto&) { options.materials = {1}; });
  refused([](auto&, auto&, auto& nodes) { --nodes; });
  refused([](auto& cells, auto&, auto&) { cells.nodes[0] = -1; });
}

}  // namespace
}  // namespace tensortopo::test
