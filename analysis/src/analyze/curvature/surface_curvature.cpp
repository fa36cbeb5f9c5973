// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/surface_curvature.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analyze/curvature/each_corner.hpp"
#include "analyze/curvature/recovered_derivatives.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

using Curvature = LevelCurvature<double>;

Vector3<double> twice_area(const SurfaceMesh& surface, std::size_t triangle) {
  const auto& t = surface.triangles[triangle];
  const auto& p = surface.points;
  return cross(p[as_size(t[1])] - p[as_size(t[0])], p[as_size(t[2])] - p[as_size(t[0])]);
}

double angle(const Vector3<double>& u, const Vector3<double>& v) {
  return elementary::atan2(length(cross(u, v)), dot(u, v));
}

}  // namespace

std::vector<Umbilic> umbilics_of(const SurfaceMesh& surface,
                                 const std::vector<std::optional<Curvature>>& corners) {
  std::vector<Umbilic> umbilics;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Vector3<double> area = twice_area(surface, i);
    if (!corners[3 * i] || !corners[3 * i + 1] || !corners[3 * i + 2] || !(length(area) > 0))
      continue;
    const auto [a, b] = tangents(unit(area));
    // The deviator of each corner's tensor in the plane of the triangle, as a complex number that
    // turns twice as fast as the directions.
    std::array<std::array<double, 2>, 3> d;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& tensor = corners[3 * i + k]->tensor;
      d[k] = {(dot(a, tensor * a) - dot(b, tensor * b)) / 2, dot(a, tensor * b)};
    }
    std::array<double, 3> w;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &u = d[(k + 1) % 3], &v = d[(k + 2) % 3];
      w[k] = u[0] * v[1] - u[1] * v[0];
    }
    const bool up = w[0] > 0 && w[1] > 0 && w[2] > 0, down = w[0] < 0 && w[1] < 0 && w[2] < 0;
    if (!up && !down) continue;
    Umbilic umbilic;
    umbilic.triangle = i;
    umbilic.twice_index = up ? 1 : -1;
    const double sum = w[0] + w[1] + w[2];
    for (std::size_t k = 0; k < 3; ++k) {
      umbilic.point += (w[k] / sum) * surface.points[as_size(surface.triangles[i][k])];
      umbilic.curvature += w[k] / sum * corners[3 * i + k]->mean();
    }
    umbilics.push_back(umbilic);
  }
  return umbilics;
}

std::vector<std::optional<Curvature>> at_corners(
    const SurfaceMesh& surface, const std::vector<std::optional<Curvature>>& vertices) {
  std::vector<std::optional<Curvature>> corners;
  corners.reserve(3 * surface.triangles.size());
  for (const auto& t : surface.triangles)
    for (const auto v : t) corners.push_back(vertices[as_size(v)]);
  return corners;
}

std::vector<std::optional<Curvature>> recovered_curvature(const SurfaceMesh& surface,
                                                          const TetMesh& mesh) {
  const RecoveredDerivatives derivatives(mesh, surface.tet);
  std::vector<SurfaceMesh::Index> tet(surface.points.size(), -1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i])
      if (tet[as_size(v)] < 0) tet[as_size(v)] = surface.tet[i];
  std::vector<std::optional<Curvature>> result(surface.points.size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t v) {
    if (tet[v] >= 0) result[v] = derivatives.curvature(tet[v], surface.points[v]);
  });
  return result;
}

SurfaceCurvature surface_curvature(const SurfaceMesh& surface, const TetMesh& mesh) {
  const auto corners =
      at_each_corner(surface, mesh, [](const auto& points, const auto& tensors, const auto& at) {
        return level_curvature(points, tensors, at);
      });

  struct Sum {
    Vector3<double> normal{};
    SymmetricTensor<double> tensor{};
    double weight = 0;
  };
  std::vector<Sum> sums(surface.points.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const double area = length(twice_area(surface, i));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corner = corners[3 * i + k];
      if (!corner) continue;
      Sum& sum = sums[as_size(surface.triangles[i][k])];
      sum.normal += area * corner->normal;
      sum.tensor = sum.tensor + area * corner->tensor;
      sum.weight += area;
    }
  }
  SurfaceCurvature result;
  result.vertices.resize(sums.size());
  result.normal_jump.assign(sums.size(), 0);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const Sum& sum = sums[v];
    if (!(sum.weight > 0) || !(length(sum.normal) > 0)) continue;
    result.vertices[v] = curvature_of(unit(sum.normal), (1 / sum.weight) * sum.tensor);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t v = as_size(surface.triangles[i / 3][i % 3]);
    if (corners[i] && result.vertices[v])
      result.normal_jump[v] =
          std::max(result.normal_jump[v], angle(corners[i]->normal, result.vertices[v]->normal));
  }
  result.umbilics = umbilics_of(surface, corners);
  return result;
}

}  // namespace tensortopo
