// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "analyze/curvature/surface_curvature.hpp"

namespace tensortopo {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Jet = CGAL::Monge_via_jet_fitting<Kernel>;
using Index = SurfaceMesh::Index;

std::vector<std::vector<Index>> neighbours_of(const SurfaceMesh& surface) {
  std::vector<std::vector<Index>> neighbours(surface.points.size());
  for (const auto& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3})
        neighbours[as_size(t[i])].push_back(t[j]);
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

/// A vertex, then the rings around it until there are enough.
std::vector<Index> gather(const std::vector<std::vector<Index>>& neighbours, Index vertex,
                          std::size_t enough) {
  std::vector<Index> found{vertex};
  std::set<Index> seen{vertex};
  for (std::size_t begin = 0; found.size() < enough && begin < found.size();) {
    const std::size_t end = found.size();
    for (std::size_t i = begin; i < end; ++i)
      for (const Index n : neighbours[as_size(found[i])])
        if (seen.insert(n).second) found.push_back(n);
    begin = end;
  }
  return found;
}

Vector3<double> vector_of(const Kernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

void require_jets() {}

std::vector<std::optional<LevelCurvature<double>>> jet_curvature(const SurfaceMesh& surface,
                                                                 std::size_t degree) {
  const auto neighbours = neighbours_of(surface);
  const std::size_t coefficients = (degree + 1) * (degree + 2) / 2;
  std::vector<std::optional<LevelCurvature<double>>> result(surface.points.size());
  tbb::parallel_for(std::size_t{0}, surface.points.size(), [&](std::size_t v) {
    const auto around = gather(neighbours, static_cast<Index>(v), 2 * coefficients);
    const auto& n = surface.normal[v];
    if (around.size() < coefficients || !(dot(n, n) > 0)) return;
    std::vector<Kernel::Point_3> points;
    for (const Index i : around) {
      const auto& p = surface.points[as_size(i)];
      points.emplace_back(p.x, p.y, p.z);
    }
    Jet jet;
    auto form = jet(points.begin(), points.end(), degree, 2);
    form.comply_wrt_given_normal(Kernel::Vector_3(n.x, n.y, n.z));
    // Over its tangent plane the surface is (k1 x^2 + k2 y^2) / 2, on the side of the normal.
    LevelCurvature<double> curvature;
    curvature.normal = vector_of(form.normal_direction());
    curvature.principal = {-form.principal_curvatures(1), -form.principal_curvatures(0)};
    curvature.directions[0] = vector_of(form.minimal_principal_direction());
    curvature.directions[1] = cross(curvature.normal, curvature.directions[0]);
    if (std::isfinite(curvature.principal[0]) && std::isfinite(curvature.principal[1]))
      result[v] = curvature;
  });
  return result;
}

}  // namespace tensortopo
