// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tensortopo {

/// Numbers of a surface's triangles that not every surface has, one each, for a file.
struct CellArray {
  std::string name;                  ///< in the file
  std::vector<std::int32_t> values;  ///< one for each triangle
};

}  // namespace tensortopo
