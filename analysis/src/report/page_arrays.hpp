// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/modes/mode_extractor.hpp"

namespace tensortopo {

/// The numbers of a page's scene, one array after the other. Each `add` gives the place of what it
/// adds: [kind, offset in bytes, length], kinds being f4, u4 and i1, little-endian.
class PageArrays {
 public:
  using Json = nlohmann::ordered_json;

  /// Positions are moved and scaled so that the mesh lies in the unit ball.
  explicit PageArrays(const TetMesh& mesh);

  /// The part of a surface from a vertex and a triangle on.
  /// @param stable  of all triangles, 1 or 0; empty if nothing is known
  Json add(const SurfaceMesh& surface, std::size_t first_vertex, std::size_t vertices,
           std::size_t first_triangle, std::size_t triangles,
           std::span<const std::int32_t> stable);
  /// The lines of one mode, as segments: all, or those of this stability.
  /// @param stable  of all lines, 1 or 0; empty if nothing is known
  Json add(const CurveMesh& curves, double mode, std::span<const std::int32_t> stable,
           bool is_stable);
  /// The edges of these tetrahedra, as segments.
  Json add(const std::vector<LeftOut>& cells);
  /// Edges at which the mesh's boundary bends, as segments.
  Json add_outline();

  /// All arrays, compressed by gzip, in base64.
  std::string text() const;

 private:
  Json place(char kind, std::size_t bytes, std::size_t length);
  void put(const Vector3<double>& p);
  template <class T>
  Json put_all(char kind, const std::vector<T>& values);

  const TetMesh& mesh_;
  Vector3<double> centre_;
  double radius_ = 1;
  std::string bytes_;
};

/// Base64 of bytes.
std::string to_base64(std::string_view bytes);
/// What a content security policy calls a script or style of this text.
std::string policy_hash(std::string_view text);

}  // namespace tensortopo
