// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/mesh/torn_faces.hpp"

namespace tensortopo {

/// The tetrahedra with which pieces meet: those with a face whose three vertices are outer vertices
/// of their piece. Outer faces of the whole mesh, and faces that have tetrahedra of two pieces, are
/// faces of these; all tetrahedra at such a face are among them.
class MeetingTets {
 public:
  /// Adds those of a piece.
  /// @param is_outer  of each of its vertices
  /// @param ids       of its points, in the whole mesh
  /// @param first_tet the id of its first tetrahedron
  void add(const TetMesh& piece, const std::vector<char>& is_outer,
           const std::vector<std::int64_t>& ids, std::int64_t first_tet);

  /// Of the whole mesh.
  /// @throws std::invalid_argument if a face has three tetrahedra, or two on one side
  TornFaces torn_faces() const;

 private:
  struct Vertex {
    std::int64_t id;
    Vector3<double> point;
    bool is_outer;
  };

  std::vector<Vertex> vertices_;  ///< more than once
  std::vector<std::array<std::int64_t, 4>> corners_;
  std::vector<std::int64_t> tets_;
};

}  // namespace tensortopo
