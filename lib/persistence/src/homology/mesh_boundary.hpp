// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::persistence {

/// The boundary surfaces of a mesh, and its Betti numbers. Surfaces that share a vertex are one.
class MeshBoundary {
 public:
  explicit MeshBoundary(const TetMesh& mesh);

  /// The number of boundary surfaces.
  std::size_t surfaces() const { return surfaces_; }
  /// The surface that a simplex lies in; nothing if it is inside. -1 is no vertex.
  std::optional<std::size_t> surface_of(std::span<const TetMesh::Index> vertices) const;
  /// Of the mesh, in dimensions 0, 1 and 2: each part of it has one boundary surface more than it
  /// has voids, and the first number follows from the Euler characteristic.
  const std::array<long, 3>& betti() const { return betti_; }
  /// The Euler characteristic, counted.
  long euler_characteristic() const { return betti_[0] - betti_[1] + betti_[2]; }

 private:
  std::vector<std::ptrdiff_t> of_vertex_;  ///< -1: inside
  std::set<std::array<TetMesh::Index, 2>> edges_;
  std::set<std::array<TetMesh::Index, 3>> faces_;
  std::size_t surfaces_ = 0;
  std::array<long, 3> betti_{};
};

}  // namespace tensortopo::persistence
