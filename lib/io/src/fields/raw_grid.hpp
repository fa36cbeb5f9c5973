// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tensortopo::detail {

/// A data array of a file, not decoded yet.
struct ArraySource {
  std::string name;
  std::size_t components = 1;
  std::vector<std::string> component_names;  ///< empty, or one each (some may be empty)
  /// Decodes: components times points (or cells) values. Throws IoError.
  std::function<std::vector<double>()> values;
};

/// An unstructured grid as a file lists it, whatever the format. Decoded, and consistent: offsets
/// rise, and corners are in range.
struct RawGrid {
  std::filesystem::path file;
  std::vector<double> coordinates;         ///< three per point
  std::vector<std::uint8_t> types;         ///< VTK's number of each cell's type
  std::vector<std::int64_t> offsets;       ///< one more than cells: where each cell's corners begin
  std::vector<std::int64_t> connectivity;  ///< the corners
  std::vector<ArraySource> point_data;
  std::vector<ArraySource> cell_data;

  std::size_t points() const { return coordinates.size() / 3; }
  std::size_t cells() const { return types.size(); }
};

/// Checks what the formats have in common: corners in range, offsets rising from 0 to the number
/// of corners. Throws FormatError.
void check_cells(const RawGrid& grid);

}  // namespace tensortopo::detail
