// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo {

/// Faces of cells that lie on faces of others without being shared: the mesh is torn there, and so
/// are surfaces in it. Other vertices in the same place (a crack, if it is meant), quadrilaterals
/// cut along both diagonals, hanging nodes. Decided exactly, of the coordinates as they are.
struct TornFaces {
  std::size_t count = 0;  ///< triangles, of both sides
  /// Of the first, and of one that it lies on; each ascending.
  std::array<std::array<std::int64_t, 3>, 2> vertices{};
  std::array<std::int64_t, 2> cells{};  ///< of the file, that these belong to

  /// What there is to say of them; empty if there are none.
  std::string text() const;
};

/// What pairs of outer faces that lie on each other tell.
///
/// @param pairs of positions in `outer`, as `unmatched_faces` gives them, in any order
/// @param outer of this mesh, as `validate` gives them
TornFaces torn_faces(std::span<const std::array<std::size_t, 2>> pairs, const TetMesh& mesh,
                     std::span<const OuterFace> outer);

}  // namespace tensortopo
