// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tensortopo {

/// Numbers of triangles and lines, or of vertices, that not every surface, or curve, has, one each,
/// for a file.
struct CellArray {
  std::string name;                       ///< in the file
  std::vector<std::int32_t> values;       ///< one for each triangle (or vertex of the surface)
  std::vector<std::int32_t> line_values;  ///< one for each line (or vertex of curves), or empty
  bool of_points = false;                 ///< the numbers are of vertices
};

}  // namespace tensortopo
