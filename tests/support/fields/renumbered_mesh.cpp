// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "renumbered_mesh.hpp"

#include <numeric>
#include <utility>

namespace tensortopo::test {

namespace {

using Index = TetMesh::Index;

std::vector<Index> random_order(std::size_t count, Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[as_size(random.integer(0, static_cast<int>(i) - 1))]);
  return order;
}

}  // namespace

RenumberedMesh renumbered_mesh(const TetMesh& mesh, Random& random) {
  RenumberedMesh result;
  result.vertices = random_order(mesh.points.size(), random);
  result.tets = random_order(mesh.tets.size(), random);
  std::vector<Index> number(mesh.points.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[as_size(result.vertices[v])] = static_cast<Index>(v);
    result.mesh.points.push_back(mesh.points[as_size(result.vertices[v])]);
    result.mesh.tensors.push_back(mesh.tensors[as_size(result.vertices[v])]);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    auto corners = mesh.tets[as_size(result.tets[t])];
    for (Index& v : corners) v = number[as_size(v)];
    for (int k = random.integer(0, 2); k > 0; --k)
      corners = {corners[0], corners[2], corners[3], corners[1]};
    for (int k = random.integer(0, 2); k > 0; --k)
      corners = {corners[1], corners[2], corners[0], corners[3]};
    result.mesh.tets.push_back(corners);
    result.mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  }
  return result;
}

}  // namespace tensortopo::test
