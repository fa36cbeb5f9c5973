// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tensortopo/mesh/cell_array.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// SHA-256, in hexadecimal, of the numbers of a field whatever the file that holds them: the number
/// of points (64 bits), their coordinates (doubles), their tensors XX YY ZZ XY YZ XZ, the number of
/// tetrahedra, and the vertices of each, ascending (64 bits each); all little-endian.
std::string field_sha256(const TetMesh& mesh);

/// The same, of a field that comes in parts: first all points, then all tensors, then all
/// tetrahedra by the ids of their vertices.
class FieldHash {
 public:
  /// @param points, tets  how many there will be
  FieldHash(std::size_t points, std::size_t tets);
  ~FieldHash();

  /// The next point.
  void add(const Vector3<double>& point);
  /// The next point's tensor.
  void add(const SymmetricTensor<double>& tensor);
  /// The next tetrahedron, by the ids of its vertices.
  void add(std::array<std::int64_t, 4> tet);
  std::string hex();  ///< after all

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same of a surface: the number of vertices, their coordinates, the number of triangles, the
/// vertices of each, and of each the id in the input of the tetrahedron that holds it.
std::string surface_sha256(const SurfaceMesh& surface, const TetMesh& mesh);

/// The same of polylines: the number of vertices, their coordinates, the number of lines, of each
/// the number of its vertices and these, and of each the id of the tetrahedron that holds it.
std::string curves_sha256(const CurveMesh& curves, const TetMesh& mesh);

/// The same of numbers alone, as doubles.
std::string numbers_sha256(std::span<const double> numbers);

/// An array that `write_surface` puts beside the geometry, with the SHA-256 of its numbers.
struct ArrayHash {
  std::string of;              ///< "points", "triangles" or "lines"
  std::string name;            ///< the array's
  std::size_t components = 1;  ///< numbers for each point or cell
  std::string sha256;          ///< of its numbers in their order, each as a double, little-endian
};

/// All arrays of a surface in a .vtp without curves but `tet`, by `of` and `name`.
/// @param more  further arrays of its triangles, or vertices
std::vector<ArrayHash> array_hashes(const SurfaceMesh& surface,
                                    std::span<const CellArray> more = {});
/// All arrays of curves in a .vtp without a surface but `tet`, by `of` and `name`.
/// @param more  further arrays of its lines, or vertices
std::vector<ArrayHash> array_hashes(const CurveMesh& curves, std::span<const CellArray> more = {});

}  // namespace tensortopo
