// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/recovered_derivatives.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analyze/curvature/level_form.hpp"
#include "tensortopo/scalar/power_of_two.hpp"

namespace tensortopo {
namespace {

using Index = TetMesh::Index;

// Coefficients of a quadratic polynomial but for its value at the vertex, and how many values it
// is to be fitted to at least.
constexpr Eigen::Index kCoefficients = 9;
constexpr std::size_t kLeastAround = 12;

/// The vertices that share a tetrahedron with each vertex.
std::vector<std::vector<Index>> neighbours(const TetMesh& mesh) {
  std::vector<std::vector<Index>> result(mesh.points.size());
  for (const auto& tet : mesh.tets)
    for (const Index v : tet)
      for (const Index w : tet)
        if (v != w) result[as_size(v)].push_back(w);
  for (auto& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

/// Those around a vertex; at the boundary, where these are few, also those around them.
std::vector<Index> patch(const std::vector<std::vector<Index>>& around, Index vertex,
                         std::size_t rings) {
  std::vector<Index> all = around[as_size(vertex)];
  for (std::size_t ring = 1; ring < rings; ++ring) {
    const std::vector<Index> inner = all;
    for (const Index v : inner)
      all.insert(all.end(), around[as_size(v)].begin(), around[as_size(v)].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  all.erase(std::remove(all.begin(), all.end(), vertex), all.end());
  return all;
}

}  // namespace

std::optional<RecoveredDerivatives::Jet> RecoveredDerivatives::fitted(
    const TetMesh& mesh, double unit, Index vertex, const std::vector<Index>& around) {
  if (around.size() < kLeastAround) return std::nullopt;
  const Vector3<double>& origin = mesh.points[as_size(vertex)];
  double size = 0;
  for (const Index v : around) {
    const Vector3<double> d = mesh.points[as_size(v)] - origin;
    size = std::max(size, length(d));
  }
  const auto rows = static_cast<Eigen::Index>(around.size());
  Eigen::Matrix<double, Eigen::Dynamic, kCoefficients> powers(rows, kCoefficients);
  Eigen::Matrix<double, Eigen::Dynamic, 5> values(rows, 5);
  const Deviator<double> here = deviator(unit * mesh.tensors[as_size(vertex)]);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Index v = around[static_cast<std::size_t>(i)];
    const Vector3<double> d = (1 / size) * (mesh.points[as_size(v)] - origin);
    powers.row(i) << d.x, d.y, d.z, d.x * d.x / 2, d.y * d.y / 2, d.z * d.z / 2, d.x * d.y,
        d.y * d.z, d.x * d.z;
    const Deviator<double> t = deviator(unit * mesh.tensors[as_size(v)]) - here;
    values.row(i) << t.a, t.b, t.xy, t.yz, t.xz;
  }
  const auto solver = powers.colPivHouseholderQr();
  if (solver.rank() < kCoefficients) return std::nullopt;
  const Eigen::Matrix<double, kCoefficients, 5> c = solver.solve(values);
  const auto deviator_at = [&](Eigen::Index i, double scale) {
    return scale * Deviator<double>{c(i, 0), c(i, 1), c(i, 2), c(i, 3), c(i, 4)};
  };
  Jet jet;
  for (Eigen::Index i = 0; i < 3; ++i)
    jet.first[static_cast<std::size_t>(i)] = deviator_at(i, 1 / size);
  for (Eigen::Index i = 0; i < 6; ++i)
    jet.second[static_cast<std::size_t>(i)] = deviator_at(3 + i, 1 / (size * size));
  return jet;
}

RecoveredDerivatives::RecoveredDerivatives(const TetMesh& mesh, const std::vector<Index>& tets)
    : mesh_(mesh), jets_(mesh.points.size()) {
  const auto around = neighbours(mesh);
  std::vector<Index> wanted;
  for (const Index tet : tets)
    wanted.insert(wanted.end(), mesh.tets[as_size(tet)].begin(), mesh.tets[as_size(tet)].end());
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  double largest = 0;
  for (const Index v : wanted) largest = std::max(largest, max_norm(mesh.tensors[as_size(v)]));
  scale_ = inverse_power(largest);
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
    const Index v = wanted[i];
    for (std::size_t rings = 1; rings <= 2 && !jets_[as_size(v)]; ++rings)
      jets_[as_size(v)] = fitted(mesh, scale_, v, patch(around, v, rings));
  });
}

std::optional<LevelCurvature<double>> RecoveredDerivatives::curvature(
    Index tet, const Vector3<double>& point) const {
  std::array<Vector3<double>, 4> corners;
  std::array<SymmetricTensor<double>, 4> tensors;
  std::array<const Jet*, 4> jets;
  for (std::size_t k = 0; k < 4; ++k) {
    const Index v = mesh_.tets[as_size(tet)][k];
    corners[k] = mesh_.points[as_size(v)];
    tensors[k] = scale_ * mesh_.tensors[as_size(v)];
    if (!jets_[as_size(v)]) return std::nullopt;
    jets[k] = &*jets_[as_size(v)];
  }
  const auto weights = barycentric_coordinates(corners, point);
  if (!weights) return std::nullopt;
  Deviator<double> t{};
  Jet jet{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double w = (*weights)[k];
    t = t + w * deviator(tensors[k]);
    for (std::size_t i = 0; i < 3; ++i) jet.first[i] = jet.first[i] + w * jets[k]->first[i];
    for (std::size_t i = 0; i < 6; ++i) jet.second[i] = jet.second[i] + w * jets[k]->second[i];
  }
  auto form = level_form(t, jet.first);
  if (!form) return std::nullopt;
  // What the second derivatives of the field add to those of the function.
  const auto& s = jet.second;
  form->hessian = form->hessian + SymmetricTensor<double>{form->along(s[0]), form->along(s[1]),
                                                          form->along(s[2]), form->along(s[3]),
                                                          form->along(s[4]), form->along(s[5])};
  return level_curvature(form->gradient, form->hessian);
}

}  // namespace tensortopo
