// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

inline constexpr auto invalid = IoError::Kind::invalid;
inline constexpr auto inapplicable = IoError::Kind::inapplicable;

/// A file of this name in a folder of this test's own.
std::filesystem::path temporary(const std::string& name);

/// Writes a file there, and gives its path.
std::filesystem::path put(const std::string& name, const std::string& bytes);
std::string slurp(const std::filesystem::path& file);

/// A cube of n^3 small cubes, six tetrahedra each, with tensors that are no round numbers.
TetMesh cube_field(int n);

/// The sum of the tetrahedra's volumes, with signs.
double volume_of(const TetMesh& mesh);

/// A .vtu in plain text, to be spoiled part by part. One tetrahedron, tensor `stress`.
struct TextVtu {
  std::string points = "4", cells = "1";
  std::string coordinates = "0 0 0  1 0 0  0 1 0  0 0 1";
  std::string connectivity = "0 1 2 3", offsets = "4", types = "10";
  std::string point_data = array("stress", 6, "1 2 3 4 5 6  1 2 3 4 5 7  1 2 3 4 5 8  1 2 3 4 5 9");
  std::string cell_data;
  std::string header =
      R"(type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64")";

  static std::string array(const std::string& name, int components, const std::string& numbers,
                           const std::string& type = "Float64");
  std::string str() const;
};

/// The same, of a legacy file.
std::string text_legacy(const std::string& attributes);

/// The error of reading a file; fails the test if there is none.
IoError error_of(const std::filesystem::path& file, const ReadOptions& options = {});

/// Expects an error of this kind whose message names the file and holds every part, on one line.
void expect_error(const std::filesystem::path& file, IoError::Kind kind,
                  const std::vector<std::string>& parts, const ReadOptions& options = {});

/// How VTK writes a file.
struct VtkStyle {
  enum class Mode { ascii, binary, appended_base64, appended_raw };
  enum class Compressor { none, zlib, lz4, lzma };
  Mode mode = Mode::appended_raw;
  Compressor compressor = Compressor::zlib;
  bool wide_header = true;
  bool big_endian = false;
  std::size_t block = 1u << 15;
};

/// Writes a field with VTK's own writers, as 6 or 9 components; with a triangle and other arrays.
void vtk_write_vtu(const TetMesh& mesh, const std::filesystem::path& file, const VtkStyle& style,
                   int components = 6, bool single_precision = false);
void vtk_write_legacy(const TetMesh& mesh, const std::filesystem::path& file, bool binary,
                      bool version_5, int components = 6);

/// Compares bit for bit, cell ids apart.
void expect_same_field(const TetMesh& is, const TetMesh& should);

}  // namespace tensortopo::test
