// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "landmarks.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "departures.hpp"

namespace tensortopo::persistence {
namespace {

/// Rounded barycentric weights, zero but at the vertices of the carrier.
TetWeights weights_of(const TetMesh& mesh, TetMesh::Index tet, const Vector3<double>& point,
                      const std::array<CurveMesh::Index, 4>& carrier) {
  const auto& corners = mesh.tets[as_size(tet)];
  const auto vector = [](const Vector3<double>& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  const Eigen::Vector3d origin = vector(mesh.points[as_size(corners[0])]);
  Eigen::Matrix3d sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides.col(static_cast<Eigen::Index>(i)) = vector(mesh.points[as_size(corners[i + 1])]) - origin;
  const Eigen::Vector3d x = sides.partialPivLu().solve(vector(point) - origin);
  TetWeights weights{1 - x.sum(), x(0), x(1), x(2)};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_used = std::find(carrier.begin(), carrier.end(), corners[i]) != carrier.end();
    weights[i] = is_used && std::isfinite(weights[i]) ? std::max(weights[i], 0.0) : 0;
  }
  return weights;
}

/// Wider by 2^-36 of the largest component.
DeviatorBox widened(DeviatorBox box) {
  double largest = 0;
  for (std::size_t i = 0; i < 5; ++i)
    largest = std::max({largest, std::abs(box.low[i]), std::abs(box.high[i])});
  for (std::size_t i = 0; i < 5; ++i) {
    box.low[i] -= 0x1p-36 * largest;
    box.high[i] += 0x1p-36 * largest;
  }
  return box;
}

}  // namespace

void Landmarks::add_curves(const TetMesh& mesh, const CurveMesh& curves) {
  for (std::size_t line = 0; line < curves.lines.size(); ++line) {
    const auto tet = static_cast<TetMesh::Index>(curves.tet[line]);
    const auto tensors = tensors_of(mesh, tet);
    for (const auto v : curves.lines[line]) {
      Landmark mark;
      mark.weights =
          weights_of(mesh, tet, curves.points[as_size(v)], curves.carrier_vertices[as_size(v)]);
      if (mark.weights == TetWeights{}) continue;
      mark.deviator = widened(deviator_box(tensors, mark.weights));
      mark.maximum = as_size(curves.component[line]);
      by_tet_[tet].push_back(mark);
    }
  }
}

void Landmarks::add_point(const TetMesh& mesh, const VertexStars& stars,
                          const std::array<TetMesh::Index, 4>& vertices,
                          const std::array<double, 4>& weights, const DeviatorBox& deviator,
                          std::size_t maximum) {
  for (const auto tet : stars.around(vertices)) {
    Landmark mark;
    mark.deviator = deviator;
    mark.maximum = maximum;
    for (std::size_t i = 0; i < 4; ++i)
      if (vertices[i] >= 0) mark.weights[corner_of(mesh, tet, vertices[i])] = weights[i];
    by_tet_[tet].push_back(mark);
  }
}

std::span<const Landmark> Landmarks::in(TetMesh::Index tet) const {
  const auto found = by_tet_.find(tet);
  return found == by_tet_.end() ? std::span<const Landmark>() : found->second;
}

}  // namespace tensortopo::persistence
