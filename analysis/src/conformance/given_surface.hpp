// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Triangles of somebody's surface, with what was done to them. Only `points` and `triangles` of
/// the surface are filled.
struct GivenSurface {
  SurfaceMesh surface;
  std::size_t merged_points = 0;        ///< points dropped as copies
  std::size_t collapsed_triangles = 0;  ///< dropped: two corners are one, or a triangle is repeated
  /// All coordinates fit into float32: they may have been rounded to it.
  bool is_single_precision = true;
  std::size_t seam_edges = 0;  ///< pairs of boundary edges at one place that shared no vertices
};

/// What a file holds of one mode's surface.
struct ReadTriangles {
  SurfaceMesh surface;          ///< `points` and `triangles`
  std::size_t other_modes = 0;  ///< triangles left out, being of other modes
};

/// The triangles of a .vtp, .ply, .stl, .obj or .off file (see `read_surface_file`); polygons are
/// triangulated.
///
/// Where the file holds the surfaces of several modes, distinguished by its point data `mode` as in
/// what `extract` writes, those of `mode` are taken, rounded to double or float32.
/// Throws IoError.
ReadTriangles read_triangles(const std::filesystem::path& file, const ModeValue& mode);

/// Merges points: those of equal coordinates, or with `distance` > 0 those whose coordinates fall
/// into one box of a lattice of that size. In order of first use.
///
/// Seams are counted before: edges with one triangle whose ends agree with another's in place, but
/// not in number. (Of a format that shares no vertices, .stl, every edge is one: pass
/// `shares_vertices` = false to count none.)
GivenSurface merge_points(const SurfaceMesh& triangles, double distance = 0,
                          bool shares_vertices = true);

}  // namespace tensortopo
