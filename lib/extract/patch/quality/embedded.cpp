// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/embedded.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "extract/patch/patch_defects.hpp"
#include "tensortopo/extract/scaled_field.hpp"

namespace tensortopo {

bool is_embedded(const SurfaceMesh& surface) {
  std::vector<PatchTriangle> triangles;
  triangles.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles)
    triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                         static_cast<std::uint32_t>(t[2])});
  return are_embedded(surface.points, triangles);
}

std::vector<TetMesh::Index> tets_not_embedded(const TetMesh& mesh, const SurfaceMesh& surface) {
  using Index = TetMesh::Index;
  const ScaledField<double> field(mesh);
  std::vector<std::pair<Index, std::size_t>> order;  // tetrahedra and their triangles
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) order.emplace_back(surface.tet[i], i);
  std::sort(order.begin(), order.end());
  std::vector<Index> result;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Index tet = order[begin].first;
    PlacedPatch patch;
    for (; end < order.size() && order[end].first == tet; ++end) {
      const auto& t = surface.triangles[order[end].second];
      patch.ids.insert(patch.ids.end(), t.begin(), t.end());
    }
    std::sort(patch.ids.begin(), patch.ids.end());
    patch.ids.erase(std::unique(patch.ids.begin(), patch.ids.end()), patch.ids.end());
    for (const auto id : patch.ids) patch.points.push_back(surface.points[as_size(id)]);
    const auto place = [&](Index id) {
      return static_cast<std::uint32_t>(
          std::lower_bound(patch.ids.begin(), patch.ids.end(), id) - patch.ids.begin());
    };
    for (std::size_t i = begin; i < end; ++i) {
      const auto& t = surface.triangles[order[i].second];
      patch.triangles.push_back({place(t[0]), place(t[1]), place(t[2])});
    }
    const auto& v = mesh.tets[as_size(tet)];
    if (std::any_of(v.begin(), v.end(), [&](Index i) { return field.is_zero[as_size(i)] != 0; }))
      continue;
    std::array<Vector3<double>, 4> points;
    std::array<int, 4> exponents{};
    std::array<Deviator<double>, 4> tensors;
    for (std::size_t i = 0; i < 4; ++i) {
      points[i] = mesh.points[as_size(v[i])];
      exponents[i] = field.exponents[as_size(v[i])];
      tensors[i] = field.tensors[as_size(v[i])];
    }
    if (defects_of(patch, UpwardTest(points, exponents, tensors)).any()) result.push_back(tet);
  }
  return result;
}

}  // namespace tensortopo
