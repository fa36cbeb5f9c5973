// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "embedding/surface_defects.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::embedding {

/// Coordinates as they are written: .vtp, .ply, .obj and .off hold the same doubles.
inline Surface surface_of(const SurfaceMesh& mesh) {
  Surface surface;
  for (const auto& p : mesh.points) surface.points.push_back({p.x, p.y, p.z});
  surface.triangles = mesh.triangles;
  surface.tet = mesh.tet;
  return surface;
}

inline Field field_of(const TetMesh& mesh) {
  Field field;
  for (const auto& p : mesh.points) field.points.push_back({p.x, p.y, p.z});
  for (const auto& t : mesh.tensors) field.tensors.push_back({t.xx, t.yy, t.zz, t.xy, t.yz, t.xz});
  field.tets = mesh.tets;
  return field;
}

}  // namespace tensortopo::embedding
