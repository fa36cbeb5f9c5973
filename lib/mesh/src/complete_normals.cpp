// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/complete_normals.hpp"

#include <algorithm>
#include <vector>

namespace tensortopo {
namespace {

bool is_zero(const Vector3<double>& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// In as many rounds as it takes.
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

}  // namespace

void complete_normals(SurfaceMesh& surface) {
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

}  // namespace tensortopo
