// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "tensortopo/field/mode_along_segments.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "vertex_stars.hpp"

namespace tensortopo::persistence {

/// A place in a tetrahedron that belongs to a maximum.
struct Landmark {
  TetWeights weights{};
  DeviatorBox deviator;  ///< holds that of the maximum itself
  std::size_t maximum = 0;
};

class Landmarks {
 public:
  /// The vertices of curves; component i is maximum i.
  void add_curves(const TetMesh& mesh, const CurveMesh& curves);
  /// A point inside a simplex, in each tetrahedron around.
  void add_point(const TetMesh& mesh, const VertexStars& stars,
                 const std::array<TetMesh::Index, 4>& vertices,
                 const std::array<double, 4>& weights, const DeviatorBox& deviator,
                 std::size_t maximum);

  std::span<const Landmark> in(TetMesh::Index tet) const;

 private:
  std::unordered_map<TetMesh::Index, std::vector<Landmark>> by_tet_;
};

}  // namespace tensortopo::persistence
