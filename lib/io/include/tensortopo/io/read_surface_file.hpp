// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// Lists of point numbers of different lengths.
struct IndexLists {
  std::vector<std::int32_t> points;  ///< of all lists, one after the other
  std::vector<std::size_t> ends;     ///< of each list: where it ends in `points`

  /// How many lists.
  std::size_t size() const { return ends.size(); }
  /// Where a list begins in `points`.
  std::size_t begin_of(std::size_t i) const { return i == 0 ? 0 : ends[i - 1]; }
};

/// Numbers for each point or cell.
struct SurfaceArray {
  std::string name;            ///< as in the file
  std::size_t components = 1;  ///< numbers for each point or cell
  std::vector<double> values;  ///< point by point, or cell by cell
  bool is_integer = false;     ///< the file declares it so
};

/// What a file of a surface or of curves holds.
struct SurfaceFile {
  std::vector<Vector3<double>> points;   ///< finite
  IndexLists lines;                      ///< two points or more each
  IndexLists polygons;                   ///< three points or more each
  std::vector<SurfaceArray> point_data;  ///< one value for each point
  /// One value for each line, then one for each polygon.
  std::vector<SurfaceArray> cell_data;
  /// Of a .vtp: its arrays of one string, by name; of surfaces that were extracted: `input_sha256`,
  /// `tensor` and others.
  std::map<std::string, std::string> texts;
  /// Of a .vtp: names of the point data that it marks as scalars and as normals; may be empty.
  std::string scalars, normals;

  /// The array of this name; null if there is none.
  const SurfaceArray* find_point_data(const std::string& name) const;
  /// The same of cell data.
  const SurfaceArray* find_cell_data(const std::string& name) const;
};

/// Reads a surface from any program: .vtp, .ply, .obj, .off or .stl, by the name's extension.
///
/// | extension | taken                                                                          |
/// | .vtp      | ASCII, inline or appended, plain or compressed, either byte order; strips become
///               triangles, vertices are left out, all arrays of numbers are kept               |
/// | .ply      | ASCII and binary of either byte order; faces, edges as lines; scalar properties
///               of vertices are kept as arrays                                                 |
/// | .obj      | `v`, `f`, `l`, also with relative numbers                                      |
/// | .off      | ASCII, also COFF, NOFF, CNOFF                                                  |
/// | .stl      | ASCII and binary; each triangle has its own three points                       |
///
/// Laws      (1) coordinates are finite and exactly those of the file; lists name points that
///           there are; (2) any bytes whatever give a result or an IoError of one line, with memory
///           in proportion to the file.
/// Throws    IoError (`unreadable`, `invalid`).
SurfaceFile read_surface_file(const std::filesystem::path& file);

/// The polygons as triangles: each is cut at its ears, seen along its mean normal.
/// @param of  for each triangle its polygon, if it is not null
std::vector<std::array<std::int32_t, 3>> triangulated(const SurfaceFile& file,
                                                      std::vector<std::size_t>* of = nullptr);

}  // namespace tensortopo
