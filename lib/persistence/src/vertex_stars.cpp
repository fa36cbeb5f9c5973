// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertex_stars.hpp"

#include <algorithm>
#include <numeric>

namespace tensortopo::persistence {

VertexStars::VertexStars(const TetMesh& mesh) : mesh_(mesh), begin_(mesh.points.size() + 1, 0) {
  for (const auto& tet : mesh.tets)
    for (const auto v : tet) ++begin_[as_size(v) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  tets_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto v : mesh.tets[t]) tets_[next[as_size(v)]++] = static_cast<TetMesh::Index>(t);
}

std::vector<TetMesh::Index> VertexStars::around(std::span<const TetMesh::Index> vertices) const {
  std::vector<TetMesh::Index> tets;
  for (const auto tet : of(vertices[0])) {
    const auto has = [&](TetMesh::Index v) { return v < 0 || corner_of(mesh_, tet, v) < 4; };
    if (std::all_of(vertices.begin(), vertices.end(), has)) tets.push_back(tet);
  }
  return tets;
}

std::size_t corner_of(const TetMesh& mesh, TetMesh::Index tet, TetMesh::Index vertex) {
  const auto& corners = mesh.tets[as_size(tet)];
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) -
                                  corners.begin());
}

}  // namespace tensortopo::persistence
