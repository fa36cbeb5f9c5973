// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Which field a surface is of: the bytes of its file, and the name of its array.
struct FieldOrigin {
  std::string sha256, tensor;  ///< empty if not known
};

/// What the file of a surface says of that.
FieldOrigin origin_of(vtkPolyData& data);

/// The triangles of a .vtp file; polylines are left out.
struct SurfaceInput {
  vtkSmartPointer<vtkPolyData> file;  ///< as read
  SurfaceMesh surface;  ///< `points`, `triangles`; `normal`, `mode`, `value` if it has them
  std::vector<std::int64_t> cell_ids;  ///< of each triangle: the file's array `tet`; may be empty
};

/// Throws IoError: no file, not a .vtp, cells other than triangles and lines, points or lines
/// without triangles. An empty file is the surface of a mode that the field does not have.
SurfaceInput read_surface(const std::filesystem::path& file);

/// Fills `surface.tet` from the ids, and makes sure that each triangle is in its tetrahedron.
/// Throws IoError if the surface is not one of this field.
void locate_in_mesh(SurfaceInput& input, const TetMesh& mesh, const FieldOrigin& field,
                    const std::filesystem::path& file);

/// The curvature that we know is that of levels of the mode: throws IoError if the surface is one
/// of another invariant.
void require_modes(const SurfaceInput& input, const std::filesystem::path& file);

}  // namespace tensortopo
