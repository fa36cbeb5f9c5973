// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/scene/line_field.hpp"

namespace tensortopo {

/// A surface cut into triangles small enough to carry a texture on their vertices.
struct FineSurface {
  using Index = SurfaceMesh::Index;

  std::vector<SurfacePlace> vertices;          ///< each in a triangle of the surface
  std::vector<std::array<double, 3>> weights;  ///< of that triangle's corners
  std::vector<std::array<Index, 3>> triangles;
};

/// Halves edges, with all triangles around them, until none is longer than `longest`, or there are
/// `most` vertices or more (about four times as many at most, if the surface has fewer). The first
/// vertices are those of the surface.
FineSurface fine_surface(const SurfaceMesh& surface, double longest, std::size_t most);

}  // namespace tensortopo
