// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/append_surface.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

// Whether an array is there in one surface and missing in the other.
template <class T>
void append(std::vector<T>& array, std::vector<T>& part, std::size_t length,
            std::size_t part_length) {
  if ((array.size() == length) != (part.size() == part_length)) {
    throw std::invalid_argument("append_surface: an array is filled in one part only");
  }
  array.insert(array.end(), part.begin(), part.end());
}

}  // namespace

void append_surface(SurfaceMesh& surface, SurfaceMesh part) {
  if (part.points.empty()) return;
  if (surface.points.empty()) {
    surface = std::move(part);
    return;
  }
  const std::size_t vertices = surface.points.size(), new_vertices = part.points.size();
  const std::size_t triangles = surface.triangles.size(), new_triangles = part.triangles.size();
  constexpr auto limit = static_cast<std::size_t>(std::numeric_limits<Index>::max());
  if (new_vertices > limit - vertices || new_triangles > limit - std::min(limit, triangles)) {
    throw std::length_error("append_surface: more vertices or triangles than 32 bits can number");
  }

  Index first_component = 0;
  for (const Index c : surface.component) first_component = std::max(first_component, c + 1);
  for (Index& c : part.component) c += first_component;
  for (auto& triangle : part.triangles) {
    for (Index& v : triangle) v += static_cast<Index>(vertices);
  }

  const auto per_vertex = [&](auto& a, auto& b) { append(a, b, vertices, new_vertices); };
  const auto per_triangle = [&](auto& a, auto& b) { append(a, b, triangles, new_triangles); };
  per_vertex(surface.carrier, part.carrier);
  per_vertex(surface.carrier_id, part.carrier_id);
  per_vertex(surface.carrier_vertices, part.carrier_vertices);
  per_vertex(surface.medium_eigenvector, part.medium_eigenvector);
  per_vertex(surface.dominant_eigenvector, part.dominant_eigenvector);
  per_vertex(surface.normal, part.normal);
  per_vertex(surface.mode, part.mode);
  per_vertex(surface.residual, part.residual);
  per_vertex(surface.value, part.value);
  per_triangle(surface.tet, part.tet);
  per_triangle(surface.component, part.component);
  per_vertex(surface.points, part.points);
  per_triangle(surface.triangles, part.triangles);
}

void append_curves(CurveMesh& curves, CurveMesh part) {
  if (part.points.empty()) return;
  if (curves.points.empty()) {
    curves = std::move(part);
    return;
  }
  const std::size_t vertices = curves.points.size(), new_vertices = part.points.size();
  const std::size_t lines = curves.lines.size(), new_lines = part.lines.size();
  if (new_vertices > static_cast<std::size_t>(std::numeric_limits<Index>::max()) - vertices) {
    throw std::length_error("append_curves: more vertices than 32 bits can number");
  }
  Index first_component = 0;
  for (const Index c : curves.component) first_component = std::max(first_component, c + 1);
  for (Index& c : part.component) c += first_component;
  for (auto& line : part.lines) {
    for (Index& v : line) v += static_cast<Index>(vertices);
  }
  const auto per_vertex = [&](auto& a, auto& b) { append(a, b, vertices, new_vertices); };
  const auto per_line = [&](auto& a, auto& b) { append(a, b, lines, new_lines); };
  per_vertex(curves.carrier, part.carrier);
  per_vertex(curves.carrier_vertices, part.carrier_vertices);
  per_vertex(curves.dominant_eigenvector, part.dominant_eigenvector);
  per_vertex(curves.mode, part.mode);
  per_vertex(curves.separation, part.separation);
  per_vertex(curves.residual, part.residual);
  per_line(curves.tet, part.tet);
  per_line(curves.component, part.component);
  per_vertex(curves.points, part.points);
  per_line(curves.lines, part.lines);
}

}  // namespace tensortopo
