// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/crossed_part.hpp"

#include <cstddef>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// The numbers that are marked, ascending.
std::vector<Index> numbers_of(const std::vector<char>& is_marked) {
  std::vector<Index> numbers;
  for (std::size_t i = 0; i < is_marked.size(); ++i)
    if (is_marked[i] != 0) numbers.push_back(static_cast<Index>(i));
  return numbers;
}

}  // namespace

std::vector<Index> inverse_numbers(const std::vector<Index>& numbers, std::size_t count) {
  std::vector<Index> result(count, -1);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    result[as_size(numbers[i])] = static_cast<Index>(i);
  return result;
}

CrossedPart crossed_part(const TetMesh& mesh, const Extraction& extraction) {
  std::vector<char> is_named(mesh.tets.size(), 0), is_near(mesh.points.size(), 0);
  for (const Index t : extraction.surface.tet) is_named[as_size(t)] = 1;
  for (const Index t : extraction.not_embedded) is_named[as_size(t)] = 1;
  for (const auto& cell : extraction.unresolved) is_named[as_size(cell.tet)] = 1;
  for (const auto& cell : extraction.topology.tets) is_named[as_size(cell.tet)] = 1;
  for (const auto& cell : extraction.topology.cones) is_named[as_size(cell.tet)] = 1;
  CrossedPart part{{}, {}, numbers_of(is_named)};
  for (const Index t : part.tets)
    for (const Index v : mesh.tets[as_size(t)]) is_near[as_size(v)] = 1;
  part.vertices = numbers_of(is_near);
  for (const Index v : part.vertices) {
    part.mesh.points.push_back(mesh.points[as_size(v)]);
    part.mesh.tensors.push_back(mesh.tensors[as_size(v)]);
  }
  const auto number = inverse_numbers(part.vertices, mesh.points.size());
  for (const Index t : part.tets) {
    auto corners = mesh.tets[as_size(t)];
    for (Index& v : corners) v = number[as_size(v)];
    part.mesh.tets.push_back(corners);
  }
  return part;
}

}  // namespace tensortopo
