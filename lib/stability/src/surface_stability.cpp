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
  std::vector<Index> left_out;
  for (std::size_t t = 0; t < stability.tets.size(); ++t)
    if (stability.tets[t] == Stability::unresolved) left_out.push_back(static_cast<Index>(t));
  auto result = components_beside(mesh, tets, components, left_out);
  for (char& is_stable : result) is_stable = !is_stable;
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (stability.tets[as_size(tets[i])] != Stability::stable) result[as_size(components[i])] = 0;
  return result;
}

}  // namespace

std::vector<char> components_beside(const TetMesh& mesh, const std::vector<Index>& tets,
                                    const std::vector<Index>& components,
                                    const std::vector<Index>& left_out) {
  const auto last = std::max_element(components.begin(), components.end());
  std::vector<char> result(last == components.end() ? 0 : as_size(*last) + 1, 0);
  if (left_out.empty()) return result;
  std::vector<std::array<Index, 3>> beside;
  for (const Index t : left_out)
    for (const auto& face : faces_of(mesh.tets[as_size(t)])) beside.push_back(face);
  std::sort(beside.begin(), beside.end());
  for (std::size_t i = 0; i < tets.size(); ++i)
    for (const auto& face : faces_of(mesh.tets[as_size(tets[i])]))
      if (std::binary_search(beside.begin(), beside.end(), face))
        result[as_size(components[i])] = 1;
  return result;
}

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
