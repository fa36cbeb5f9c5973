// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grids/lattice.hpp"

namespace tensortopo::detail {

/// Of arrays with more components than tensors at 27 nodes of a cell have, no names are kept.
inline constexpr std::size_t most_named_components = 27 * 9;

/// A data array of a file, not decoded yet.
struct ArraySource {
  std::string name;
  std::size_t components = 1;
  std::vector<std::string> component_names;  ///< empty, or one each (some may be empty)
  /// Decodes: components times points (or cells) values. Throws IoError.
  std::function<std::vector<double>()> values;
  bool has_no_usual_order = false;  ///< of components: the format has no convention
};

/// An unstructured grid as a file lists it, whatever the format. Decoded, and consistent: offsets
/// rise, and corners are in range. Of a lattice points and cells are made by `fill_lattice`: a file
/// of a few bytes may promise many, and its arrays are read first.
struct RawGrid {
  std::filesystem::path file;
  std::vector<double> coordinates;         ///< three per point
  std::vector<std::uint8_t> types;         ///< VTK's number of each cell's type
  std::vector<std::int64_t> offsets;       ///< one more than cells: where each cell's corners begin
  std::vector<std::int64_t> connectivity;  ///< the corners
  std::vector<ArraySource> point_data;
  std::vector<ArraySource> cell_data;

  std::optional<Lattice> lattice;  ///< whose points and cells these are to be
  bool is_regular = false;         ///< made of a lattice

  std::size_t points() const { return lattice ? lattice->points() : coordinates.size() / 3; }
  std::size_t cells() const { return lattice ? lattice->cubes() : types.size(); }
};

/// Makes points and voxels of the lattice, if there is one. Throws FormatError.
void fill_lattice(RawGrid& grid);

/// Checks what the formats have in common: corners in range, offsets rising from 0 to the number
/// of corners. Throws FormatError.
void check_cells(const RawGrid& grid);

}  // namespace tensortopo::detail
