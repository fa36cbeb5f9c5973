// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

std::array<std::array<Index, 3>, 4> faces_of(std::array<Index, 4> v) {
  std::sort(v.begin(), v.end());
  return {{{v[1], v[2], v[3]}, {v[0], v[2], v[3]}, {v[0], v[1], v[3]}, {v[0], v[1], v[2]}}};
}

/// By component, for the tetrahedron and the component of each of its cells: all tetrahedra are
/// stable, and none has a face in common with one that was left out: there surface or curve may
/// end.
std::vector<char> stable_components(const TetMesh& mesh, const std::vector<Index>& tets,
                                    const std::vector<Index>& components,
                                    const LevelStability& stability) {
  const auto last = std::max_element(components.begin(), components.end());
  std::vector<char> result(last == components.end() ? 0 : as_size(*last) + 1, 1);
  std::vector<std::array<Index, 3>> beside;
  for (std::size_t t = 0; t < stability.tets.size(); ++t)
    if (stability.tets[t] == Stability::unresolved)
      for (const auto& face : faces_of(mesh.tets[t])) beside.push_back(face);
  std::sort(beside.begin(), beside.end());
  for (std::size_t i = 0; i < tets.size(); ++i) {
    char& is_stable = result[as_size(components[i])];
    if (!is_stable) continue;
    is_stable = stability.tets[as_size(tets[i])] == Stability::stable;
    if (beside.empty()) continue;
    for (const auto& face : faces_of(mesh.tets[as_size(tets[i])]))
      if (std::binary_search(beside.begin(), beside.end(), face)) is_stable = 0;
  }
  return result;
}

}  // namespace

SurfaceStability surface_stability(const TetMesh& mesh, const SurfaceMesh& surface,
                                   const LevelStability& stability) {
  SurfaceStability result;
  for (const Index t : surface.tet)
    result.triangles.push_back(stability.tets[as_size(t)] == Stability::stable);
  result.components = stable_components(mesh, surface.tet, surface.component, stability);
  return result;
}

std::vector<char> stable_curves(const TetMesh& mesh, const CurveMesh& curves,
                                const LevelStability& stability) {
  return stable_components(mesh, curves.tet, curves.component, stability);
}

}  // namespace tensortopo
