// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/describe_vertices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "extract/level/level_in_tet.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

namespace {

bool is_zero(const Vector3<double>& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Where triangles have no area either (a sheet smaller than coordinates tell), vertices without a
/// normal take that of a vertex next to them, in as many rounds as it takes.
void take_normals_of_neighbours(SurfaceMesh& surface) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& triangle : surface.triangles)
      for (const auto v : triangle)
        for (const auto w : triangle) {
          if (!is_zero(surface.normal[as_size(v)]) || is_zero(surface.normal[as_size(w)])) continue;
          surface.normal[as_size(v)] = surface.normal[as_size(w)];
          has_changed = true;
        }
  }
}

/// Where gradients cancel, or rounding hides them (the mode is constant but for that), the normal
/// is the mean of those of the triangles around, by their areas.
void normals_of_triangles(SurfaceMesh& surface) {
  std::vector<char> unknown(surface.normal.size());
  std::transform(surface.normal.begin(), surface.normal.end(), unknown.begin(), is_zero);
  if (std::find(unknown.begin(), unknown.end(), 1) == unknown.end()) return;
  for (const auto& triangle : surface.triangles)
    for (const auto v : triangle) {
      if (!unknown[as_size(v)]) continue;
      const auto& [a, b, c] = triangle;
      const auto& p = surface.points;
      surface.normal[as_size(v)] +=
          cross(p[as_size(b)] - p[as_size(a)], p[as_size(c)] - p[as_size(a)]);
    }
  for (std::size_t v = 0; v < unknown.size(); ++v)
    if (unknown[v]) surface.normal[v] = unit_or_zero(surface.normal[v]);
  take_normals_of_neighbours(surface);
}

}  // namespace

template <class Scalar>
void describe_vertices(const SurfaceInput<Scalar>& input, const std::vector<char>& is_apex,
                       SurfaceMesh& surface) {
  using Index = TetMesh::Index;
  const auto& field = input.field;
  const auto& mesh = input.mesh;
  const auto level = make_level<double>(input.level.value);
  const std::size_t count = surface.points.size();
  surface.normal.assign(count, {0, 0, 0});
  surface.mode.assign(count, input.level.value.approx());
  surface.residual.assign(count, 0);
  std::vector<Index> first_tet(count, -1);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const Index v : surface.triangles[i])
      if (first_tet[as_size(v)] < 0) first_tet[as_size(v)] = surface.tet[i];

  // Normals: the field is only continuous across faces, so a shared vertex gets the mean of the
  // unit gradients in the tetrahedra whose triangles meet there, each weighted by its triangles.
  const auto narrow_tensors = [&](std::size_t tet) {
    std::array<Deviator<Scalar>, 4> tensors;
    for (std::size_t i = 0; i < 4; ++i) tensors[i] = field.tensors[as_size(mesh.tets[tet][i])];
    return rounded(tensors);
  };
  const auto geometry = [&](std::size_t tet) {
    const auto& v = mesh.tets[tet];
    // A vertex isotropic must not decide on the scale.
    std::size_t other = 0;
    while (field.is_zero[as_size(v[other])]) ++other;
    std::array<int, 4> exponents;
    std::array<Vector3<double>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
      exponents[i] = field.exponents[as_size(v[field.is_zero[as_size(v[i])] ? other : i])];
      points[i] = mesh.points[as_size(v[i])];
    }
    return TetGeometry(points, exponents);
  };
  // Sums are made in the order of the triangles, a block at a time.
  constexpr std::size_t kBlock = 1 << 14;
  const std::size_t triangles = surface.triangles.size();
  std::vector<std::array<Vector3<double>, 3>> gradients(std::min(kBlock, triangles));
  for (std::size_t first = 0; first < triangles; first += kBlock) {
    const std::size_t size = std::min(kBlock, triangles - first);
    parallel_stage(input.options, "stitch", size, 1024, [&](std::size_t i) {
      const auto& corners = surface.triangles[first + i];
      const auto tet = as_size(surface.tet[first + i]);
      const auto tensors = narrow_tensors(tet);
      const auto space = geometry(tet);
      Vector3<double> sum{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = as_size(corners[k]);
        gradients[i][k] = {0, 0, 0};
        if (is_apex[v]) continue;
        const auto at = level_slope(space.balanced_tensor(surface.points[v], tensors), level);
        gradients[i][k] = unit_or_zero(space.gradient(at.slope, tensors));
        sum += gradients[i][k];
      }
      // The gradient's direction is the same along a ray.
      for (std::size_t k = 0; k < 3; ++k)
        if (is_apex[as_size(corners[k])]) gradients[i][k] = unit_or_zero(sum);
    });
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        surface.normal[as_size(surface.triangles[first + i][k])] += gradients[i][k];
  }

  parallel_stage(input.options, "stitch", count, 1024, [&](std::size_t id) {
    surface.normal[id] = unit_or_zero(surface.normal[id]);
    if (is_apex[id]) return;
    const auto tet = as_size(first_tet[id]);
    const auto t = geometry(tet).balanced_tensor(surface.points[id], narrow_tensors(tet));
    surface.residual[id] = mode_difference(t, level);
    surface.dominant_eigenvector[id] = dominant_eigenvector(t, level);
  });
  normals_of_triangles(surface);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                   \
  template void describe_vertices(const SurfaceInput<Scalar>&, const std::vector<char>&, \
                                  SurfaceMesh&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
