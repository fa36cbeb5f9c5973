// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "homology/mesh_boundary.hpp"

#include <algorithm>
#include <numeric>

#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo::persistence {

MeshBoundary::MeshBoundary(const TetMesh& mesh) : of_vertex_(mesh.points.size(), -1) {
  std::vector<TetMesh::Index> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), 0);
  const TetComplex complex = tet_complex(mesh, all);
  UnionFind parts(mesh.points.size()), sheets(mesh.points.size());
  std::vector<char> is_used(mesh.points.size(), 0), is_outer(mesh.points.size(), 0);
  const auto join = [](UnionFind& classes, TetMesh::Index v, TetMesh::Index w) {
    classes.unite(static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(w));
  };
  for (const auto& tet : mesh.tets)
    for (const auto v : tet) is_used[as_size(v)] = 1, join(parts, tet[0], v);
  for (std::size_t f = 0; f < complex.faces.size(); ++f) {
    if (complex.face_tets[f][1] >= 0) continue;
    const auto& face = complex.faces[f];
    faces_.insert(face);
    for (std::size_t i = 0; i < 3; ++i) {
      is_outer[as_size(face[i])] = 1;
      join(sheets, face[0], face[i]);
      edges_.insert({face[i == 2 ? 1 : 0], face[i == 0 ? 1 : 2]});
    }
  }
  long vertices = 0, part_count = 0;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    const auto i = static_cast<std::uint32_t>(v);
    vertices += is_used[v];
    part_count += is_used[v] != 0 && parts.find(i) == i;
    if (is_outer[v] == 0) continue;
    // Each class is named by its least member.
    const std::size_t first = sheets.find(i);
    of_vertex_[v] = first == v ? static_cast<std::ptrdiff_t>(surfaces_++) : of_vertex_[first];
  }
  const long euler = vertices - static_cast<long>(complex.edges.size()) +
                     static_cast<long>(complex.faces.size()) - static_cast<long>(mesh.tets.size());
  betti_[0] = part_count;
  betti_[2] = static_cast<long>(surfaces_) - part_count;
  betti_[1] = betti_[0] + betti_[2] - euler;
}

std::optional<std::size_t> MeshBoundary::surface_of(
    std::span<const TetMesh::Index> vertices) const {
  std::vector<TetMesh::Index> used;
  for (const auto v : vertices)
    if (v >= 0) used.push_back(v);
  std::sort(used.begin(), used.end());
  if (used.empty() || used.size() > 3 || of_vertex_[as_size(used[0])] < 0) return std::nullopt;
  if (used.size() == 2 && !edges_.contains({used[0], used[1]})) return std::nullopt;
  if (used.size() == 3 && !faces_.contains({used[0], used[1], used[2]})) return std::nullopt;
  return static_cast<std::size_t>(of_vertex_[as_size(used[0])]);
}

}  // namespace tensortopo::persistence
