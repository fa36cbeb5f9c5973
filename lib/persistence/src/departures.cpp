// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "departures.hpp"

#include <algorithm>

#include "numeric_mode.hpp"

namespace tensortopo::persistence {
namespace {

using Index = TetMesh::Index;

/// A critical point in one of the tetrahedra around it.
TetDeparture in_tet(const TetMesh& mesh, Index tet, const MeshCriticalPoint& point) {
  TetDeparture result;
  result.tet = tet;
  result.departure.deviator = point.deviator;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(point.dimension); ++i)
    result.departure.weights[corner_of(mesh, tet, point.vertices[i])] = point.weights[i];
  return result;
}

TetDeparture towards(const TetMesh& mesh, Index tet, const MeshCriticalPoint& point, Index vertex) {
  TetDeparture result = in_tet(mesh, tet, point);
  result.departure.towards[corner_of(mesh, tet, vertex)] = 1;
  return result;
}

}  // namespace

TetTensors4 tensors_of(const TetMesh& mesh, Index tet) {
  TetTensors4 tensors;
  for (std::size_t i = 0; i < 4; ++i)
    tensors[i] = mesh.tensors[as_size(mesh.tets[as_size(tet)][i])];
  return tensors;
}

std::vector<std::vector<TetDeparture>> departures(const TetMesh& mesh, const VertexStars& stars,
                                                  const MeshCriticalPoint& point) {
  const auto tets = stars.around(point.vertices);
  const auto parts = parts_of_sign(point.link, Verdict::positive);
  const auto mesh_vertices = static_cast<int>(point.around.size());
  std::vector<std::vector<TetDeparture>> result(parts.size());
  std::size_t in_simplex = 0;  // parts without a vertex of the mesh so far
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const int member : parts[i]) {
      if (member >= mesh_vertices) continue;
      const Index vertex = point.around[static_cast<std::size_t>(member)];
      for (const Index tet : tets)
        if (corner_of(mesh, tet, vertex) < 4) {
          result[i].push_back(towards(mesh, tet, point, vertex));
          break;
        }
    }
    if (!result[i].empty() || tets.empty()) continue;
    // Along the simplex itself, where the first derivative vanishes and the second is positive.
    if (point.dimension == 1) {
      const int end = parts[i][0] - mesh_vertices;
      result[i].push_back(
          towards(mesh, tets[0], point, point.vertices[static_cast<std::size_t>(end)]));
    } else {
      TetDeparture way = in_tet(mesh, tets[0], point);
      way.departure.towards = direction_of_rise(deviators_of(mesh, way.tet), way.departure.weights);
      if (in_simplex++ > 0)
        for (double& w : way.departure.towards) w = -w;
      result[i].push_back(way);
    }
    result[i].back().departure.is_critical = true;
  }
  return result;
}

}  // namespace tensortopo::persistence
