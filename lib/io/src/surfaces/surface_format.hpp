// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/io/surface_formats.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::detail {

/// A row of the table of formats of surfaces.
struct SurfaceFormatEntry {
  SurfaceFormat format;
  /// Bytes to a surface; throws FormatError. Null for .vtp, which `read_vtp` reads.
  SurfaceFile (*read)(std::string_view bytes);
  /// Geometry to bytes; throws std::range_error. Null for .vtp, which `write_vtp` makes with
  /// all arrays.
  std::string (*write)(const SurfaceMesh& surface, const CurveMesh& curves);
};

/// The row of a file by its name; null if there is none.
const SurfaceFormatEntry* surface_entry_of(const std::filesystem::path& file);

}  // namespace tensortopo::detail
