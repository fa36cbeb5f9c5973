// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo {

SurfaceStability surface_stability(const TetMesh& mesh, const SurfaceMesh& surface,
                                   const LevelStability& stability) {
  using Index = TetMesh::Index;
  SurfaceStability result;
  const auto& components = surface.component;
  const auto last = std::max_element(components.begin(), components.end());
  result.components.assign(last == components.end() ? 0 : as_size(*last) + 1, 1);
  result.triangles.resize(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    result.triangles[i] = stability.tets[as_size(surface.tet[i])] == Stability::stable;
    if (!result.triangles[i]) result.components[as_size(components[i])] = 0;
  }
  // Where tetrahedra are left out the surface ends on their faces.
  std::vector<std::array<Index, 3>> beside;
  const auto add_faces = [&](std::size_t t, auto& faces) {
    auto v = mesh.tets[t];
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < 4; ++i)
      faces.push_back({v[i == 0 ? 1 : 0], v[i <= 1 ? 2 : 1], v[i <= 2 ? 3 : 2]});
  };
  for (std::size_t t = 0; t < stability.tets.size(); ++t)
    if (stability.tets[t] == Stability::unresolved) add_faces(t, beside);
  if (beside.empty()) return result;
  std::sort(beside.begin(), beside.end());
  std::vector<std::array<Index, 3>> faces;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    faces.clear();
    add_faces(as_size(surface.tet[i]), faces);
    for (const auto& face : faces)
      if (std::binary_search(beside.begin(), beside.end(), face))
        result.components[as_size(components[i])] = 0;
  }
  return result;
}

}  // namespace tensortopo
