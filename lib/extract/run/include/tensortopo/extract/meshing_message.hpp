// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// What one tetrahedron tells another while both are meshed.
///
/// The triangles of a tetrahedron depend on its own field, on the first samples of its faces, which
/// depend on the faces, and on what other tetrahedra tell it, step by step: nearly always nothing.
/// So two extractions in which a tetrahedron is told the same mesh it alike.
struct MeshingMessage {
  /// Rounds: to a tetrahedron that shares a vertex with one that was left out, or from it.
  static constexpr std::int32_t kLeftOut = 0;
  /// From here on: across a face, which samples it asks for on it.
  static constexpr std::int32_t kFirstRequest = 1;
  /// Across a face, which samples it could do without.
  static constexpr std::int32_t kProposal = 1 << 20;
  /// From here on: across a face, which samples it refuses to let go.
  static constexpr std::int32_t kFirstRefusal = kProposal + 1;

  TetMesh::Index from = -1;  ///< the tetrahedron that tells
  TetMesh::Index to = -1;    ///< the one that is told
  std::int32_t pass = 0;     ///< around vertices that were treated otherwise, all is done again
  std::int32_t round = 0;    ///< see the constants
  std::uint64_t digest = 0;  ///< of what is said, in any order

  /// In the order of the members.
  auto operator<=>(const MeshingMessage&) const = default;
};

/// A hash of the bits of numbers.
std::uint64_t digest_of(std::span<const double> numbers);

}  // namespace tensortopo
