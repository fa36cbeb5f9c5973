// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace certificate {

/// What a file has of an unstructured grid with tensors on its points; nothing is checked but that
/// numbers are finite, and those that count are natural.
struct Grid {
  std::vector<double> points;   ///< three of each
  std::vector<double> tensors;  ///< as many of each as asked for
  std::vector<std::string> names;   ///< of the tensors' components, if the file has them
  std::vector<std::uint64_t> types, connectivity;
  std::vector<std::uint64_t> offsets;  ///< where each cell ends in `connectivity`
};

/// Whether an array marks cells or points that other readers leave out.
inline bool marks_ghosts(std::string_view name) {
  return name == "vtkGhostType" || name == "vtkGhostLevels";
}
inline std::string ghosts_refused(std::string_view name) {
  return "has marks of ghost cells or points, '" + std::string(name) +
         "'; leave them out, or make a file without with tensortopo convert";
}

}  // namespace certificate
