// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/mesh/cell_array.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// What a written file holds.
struct WriteReport {
  std::uintmax_t bytes = 0;  ///< size of the file
  std::vector<std::string> arrays;  ///< data arrays besides the geometry (.vtp only)
};

/// What a file is to hold, whether there is any of it or not.
struct OutputKinds {
  /// Which of these were asked for.
  bool mode_surfaces = false, invariant_surfaces = false, degenerate_curves = false;
};

/// A text that a .vtp carries as field data: where it comes from.
struct FileNote {
  /// The array's name, and what it says.
  std::string name, text;
};

/// Writes a surface in the format that the file's extension names.
///
/// | extension | holds                                              | coordinates               |
/// | .vtp      | all arrays that the surface has, zlib              | exact                     |
/// | .ply      | geometry, binary little endian, double             | exact                     |
/// | .obj .off | geometry, shortest decimals that read back exactly | exact                     |
/// | .stl      | geometry, binary                                   | rounded to float32        |
///
/// The arrays of a .vtp are point data `mode`, `value`, `medium_eigenvector`,
/// `dominant_eigenvector`, `normal`, `residual` and cell data `tet` (id of the cell in the input,
/// from `mesh.cell_ids`), `component`; those that are empty in `surface` are left out. Where there
/// are no points, the arrays that `kinds` have are written, of no values, for readers by name.
/// `normal` is marked as the points' normals and `mode` (or `value`) as their scalars. Arrays are
/// inline binary, which every reader of the format takes.
///
/// Laws      (1) equal surfaces give equal bytes; (2) the file appears whole or not at all: it is
///           written under another name beside its own, then renamed; (3) on failure nothing is
///           left behind, and a file that was there before is untouched.
/// Requires  each array empty or of full length, and indices in range.
/// Throws    IoError (`unwritable`; an unknown extension is one), std::invalid_argument.
WriteReport write_surface(const SurfaceMesh& surface, const TetMesh& mesh,
                          const std::filesystem::path& file, const OutputKinds& kinds = {});

/// The same with curves, as polylines of their own vertices after those of the surface.
///
/// .vtp and .obj hold a polyline for each line, .ply an edge for each segment; .off and .stl hold
/// none. In a .vtp the curves add point data `separation`; arrays that only the surface has are
/// zero at vertices of curves, and `separation` at vertices of the surface. Cell data come in VTK's
/// order, lines before triangles. Without curves the bytes are those of the surface alone. A .vtp
/// has the `notes` as field data, a string each, and `more` as cell data (zero at lines that they say nothing of) or
/// point data (-1 at vertices that they say nothing of); other formats have no place for them.
///
/// Throws    also IoError if there are curves and the format holds no polylines.
WriteReport write_surface(const SurfaceMesh& surface, const CurveMesh& curves, const TetMesh& mesh,
                          const std::filesystem::path& file, const OutputKinds& kinds = {},
                          const std::vector<FileNote>& notes = {},
                          const std::vector<CellArray>& more = {});

}  // namespace tensortopo
