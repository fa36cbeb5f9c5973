// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "extract/surface/boundary/surface_input.hpp"

namespace tensortopo {

/// Of a vertex of the mesh whose mode is exactly mu: whether the surface passes through it, or a
/// nearby level around it is extracted instead.
enum class OnLevel : char { no, meshed_through, kept_off };

/// The sides of the mesh's vertices.
struct VertexSides {
  std::vector<char> above;  ///< mode > mu; exact
  std::vector<OnLevel> on_level;
  std::vector<char> as_meshed;    ///< triangles in its tetrahedra keep their `PatchDefects`
  std::vector<double> clearance;  ///< `screen::clearance_cosine`
  std::size_t count_on_level = 0;

  bool keeps_off(const std::array<TetMesh::Index, 2>& edge) const {
    return on_level[as_size(edge[0])] == OnLevel::kept_off ||
           on_level[as_size(edge[1])] == OnLevel::kept_off;
  }
};

template <class Scalar>
VertexSides classify_vertices(const SurfaceInput<Scalar>& input);

/// Whether vertices are on one side of the level, and one of them farther from it, by the angle
/// between tensors, than from all others: then so is the simplex.
template <class Scalar, std::size_t Count>
bool is_clear(const SurfaceInput<Scalar>& input, const VertexSides& sides,
              const std::array<TetMesh::Index, Count>& vertices) {
  auto clear = as_size(vertices[0]);
  const char side = sides.above[clear];
  for (const auto w : vertices) {
    const auto v = as_size(w);
    if (sides.above[v] != side) return false;
    if (sides.clearance[v] < sides.clearance[clear]) clear = v;
  }
  const double limit = sides.clearance[clear] * input.prepared.norms[clear];
  for (const auto w : vertices) {
    const auto v = as_size(w);
    if (v != clear && !(norm_form(input.prepared.tensors()[clear], input.prepared.tensors()[v]) >
                        limit * input.prepared.norms[v]))
      return false;
  }
  return true;
}

/// Whether the level passes between the vertices, none of which is isotropic.
template <class Scalar, std::size_t Count>
bool is_crossed(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                const std::array<TetMesh::Index, Count>& vertices) {
  bool crossed = false;
  for (const auto w : vertices) {
    if (input.field.is_zero[as_size(w)]) return false;
    crossed |= sides.above[as_size(w)] != sides.above[as_size(vertices[0])];
  }
  return crossed;
}

}  // namespace tensortopo
