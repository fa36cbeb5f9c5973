// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tensortopo/io/write_surface.hpp"

namespace tensortopo::test {

inline constexpr auto unwritable = IoError::Kind::unwritable;

inline SurfaceMesh surface_of_two() {
  SurfaceMesh s;
  s.points = {{0.1, 1.0 / 3, -1e-30}, {1e30, 0, 0x1p-1074}, {0, 1, 0}, {-2.5, 1e-5, 1e5}};
  s.triangles = {{0, 1, 2}, {2, 1, 3}};
  s.mode = {0.5, 0.5, 0.5, 0.5};
  s.residual = {1e-17, 0, -1e-18, 0};
  s.normal = s.medium_eigenvector =
      s.dominant_eigenvector = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.8, 0}};
  s.tet = {1, 0};
  s.component = {0, 0};
  return s;
}

inline TetMesh mesh_of_two() {
  TetMesh mesh;
  mesh.cell_ids = {70, 5000000000};
  return mesh;
}

inline CurveMesh curve_of_three() {
  CurveMesh c;
  c.points = {{0.1, 0.2, 0.3}, {1, 2, 3}, {-1e-30, 1e30, 0}};
  c.lines = {{2, 0, 1}, {1, 2}};
  c.mode = {1, 1, 1};
  c.separation = {0.25, -1e-9, 4};
  c.residual = {1e-16, 0, 0};
  c.dominant_eigenvector = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  c.tet = {0, 1};
  c.component = {0, 0};
  return c;
}

// In VTK's order of cells: lines, then triangles.
inline std::size_t files_beside(const std::filesystem::path& file) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    ++count;
  return count;
}

}  // namespace tensortopo::test
