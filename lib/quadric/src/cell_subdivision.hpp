// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "convex_level.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Name of a vertex of the surface, the same in all tetrahedra that hold it: the segment that it is
/// on, from a place of the body to one outside. Both are given by integer coordinates over the
/// vertices of the mesh; the place in the interior of a met simplex by the sum over its corners.
struct VertexKey {
  std::array<TetMesh::Index, 4> ids;  ///< of the carrier, ascending; -1 fills up
  std::array<std::uint16_t, 4> inside, outside;
  std::int8_t nappe;

  friend auto operator<=>(const VertexKey&, const VertexKey&) = default;
};

/// A vertex of the surface as one tetrahedron sees it.
struct CellVertex {
  VertexKey key;
  Vector3<double> position;
  Vector3<double> normal;  ///< the unit gradient, which is not the same in all tetrahedra
  double value;            ///< of the invariant
};

/// The level in one tetrahedron.
struct CellLevel {
  std::vector<CellVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  bool met_inside = false;  ///< the body meets some simplex of the subdivision in its interior only
  bool meets_zero = false;  ///< holds the level and the zero tensor: no triangles
  std::size_t exact_answers = 0;
};

/// The boundary of a convex level in a tetrahedron, marched in a subdivision that its neighbours
/// share: the edgewise subdivision in pieces^3 tetrahedra, in which each edge, face and tetrahedron
/// that the body meets in its interior only has a vertex there.
///
/// Theorem (ours). Let s be a simplex with corners I in a closed convex body K, and corners O,
/// whose face is not met by K. If neither is empty, each point of s in neither face is on one
/// segment from conv(I) to conv(O), and each segment leaves K once. So the boundary of K in s is a
/// graph over conv(I) x conv(O): one disc, the polygon of marching tetrahedra, and in the faces of
/// s likewise. In the subdivision every tetrahedron is such a simplex: what is added is inside, K
/// is convex, so only simplices whose corners were all outside had to be asked. Unchanged for K at
/// value + 0: K is closed, and what does not meet it has a distance from it.
///
/// @param nodes  its vertices in ascending order; `is_even`: an even permutation of a positive one
CellLevel level_in_cell(const ConvexLevel& level, Invariant invariant, const TetMesh& mesh,
                        const std::array<TetMesh::Index, 4>& nodes, bool is_even, int pieces);

}  // namespace tensortopo
