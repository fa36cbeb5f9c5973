// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/file.hpp"
#include "input.hpp"

namespace certificate {

/// An input with what its file says besides.
struct InputFile : Input {
  std::size_t other_cells = 0;   ///< that are neither tetrahedra nor points, lines or faces
  std::size_t flat_cells = 0;    ///< points, lines and faces
  std::size_t doubled_points = 0;  ///< see `count_doubled`
  std::size_t symmetrized = 0;   ///< tensors of nine components, of which two differ
  std::string names;             ///< of the components, if the file has some
  bool names_say_order = false;  ///< whether these spell the order that was taken

  std::string sha256() const;
};

/// Numbers of each point, triangle or line of the output.
struct Array {
  std::string of;  ///< "points", "triangles" or "lines"
  std::string name;
  std::size_t components = 1;
  std::vector<double> numbers;  ///< all of one point or cell, then those of the next

  std::string sha256() const;
};

/// The output: triangles, and the cell of the input that holds each.
struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint64_t> cells;
  std::vector<Array> arrays;  ///< all others, ascending by `of` and `name`

  std::string sha256() const;
};

/// The output: polylines, and the cell of the input that holds each.
struct Polylines {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::uint32_t>> lines;  ///< two or more different points each
  std::vector<std::uint64_t> cells;
  std::vector<Array> arrays;  ///< all others, ascending by `of` and `name`

  std::string sha256() const;
};

/// SHA-256 of bytes, in hexadecimal.
std::string sha256_of(std::string_view bytes);

/// The components of an order in words, "XX YY ZZ XY YZ XZ"; empty for an unknown one.
std::string listing_of(const std::string& order);

/// Reads a .vtu of one piece (ascii, inline or appended, plain or zlib, of either byte order), or a
/// legacy .vtk (ASCII or BINARY). Every number is finite and every index in range. Names of
/// components that spell another order are refused, and so are tetrahedra that `defect_of` names.
/// Throws Malformed.
InputFile read_input(const File& file, const std::string& tensor, const std::string& components);

/// Radii at the points of an input, none negative or above 2^1000.
struct Radii {
  std::vector<double> numbers;

  std::string sha256() const;
};

/// Reads an array of the input's points with one component. Throws Malformed.
Radii read_radii(const File& file, const std::string& array, std::size_t points);

/// Reads a .vtp with triangles only, or polylines only, a cell array `tet`, and any others.
Triangles read_triangles(const File& file);
Polylines read_polylines(const File& file);

}  // namespace certificate
