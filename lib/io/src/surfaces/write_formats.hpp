// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "output/atomic_file.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

// Geometry in simple formats, as bytes.
/// Of a .ply with the level of each vertex, if they have one: property `mode` or `value`.
std::string to_ply(const SurfaceMesh& surface, const CurveMesh& curves);
std::string to_obj(const SurfaceMesh& surface, const CurveMesh& curves);
std::string to_off(const SurfaceMesh& surface);
/// Throws std::range_error if a coordinate is too large for float32.
std::string to_stl(const SurfaceMesh& surface);

/// Geometry and arrays, whose names it appends to `names`; without points those of `kinds`.
/// Finishes the file. Throws IoError (unwritable).
void write_vtp(const SurfaceMesh& surface, const CurveMesh& curves, const TetMesh& mesh,
               const OutputKinds& kinds, const std::vector<FileNote>& notes,
               const std::vector<CellArray>& more, OutputFile& file,
               std::vector<std::string>& names);

}  // namespace tensortopo::detail
