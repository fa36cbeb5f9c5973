// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tensortopo/field/deviator_box.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/sweep/local_change.hpp"

namespace tensortopo {

/// A point of a mesh at whose mode the topology of the mode surfaces changes, or may do.
struct MeshCriticalPoint {
  /// The mode there is within.
  double low = -1, high = 1;
  /// 1 - mode^2 there is within: see `CriticalPoint`.
  double gap_low = 0, gap_high = 1;
  std::array<TetMesh::Index, 4> vertices;  ///< of the simplex that it is inside of; -1 fills up
  int dimension = 0;                       ///< of that simplex
  Vector3<double> point{};                 ///< about where
  std::array<double, 4> weights{};         ///< the same, of `vertices`, with sum 1
  bool is_certain = false;                 ///< see `CriticalPoint`, as of the next two
  DeviatorBox deviator;                    ///< there
  int index = 0;                           ///< see `CriticalPoint`
  /// Where the mode goes from there. The first vertices of the link are those of the mesh that
  /// `around` lists. On an edge two more stand for its two ends; on a face four, in turn, for
  /// directions of rise and fall in it; in a tetrahedron there are six for three pairs of opposite
  /// directions.
  SignedLink link;
  std::vector<TetMesh::Index> around;  ///< neighbours, as `link` numbers them
  LocalEffect effect;                  ///< what happens to the level
};

/// All modes at which the topology may change.
struct MeshCriticalValues {
  /// Those that are not proved to be regular, by `low`.
  std::vector<MeshCriticalPoint> points;
  /// Critical points of the mode along a vertex, edge, face or tetrahedron, by its dimension:
  /// those at whose mode some cell's level changes.
  std::array<std::size_t, 4> looked_at{};
};

/// All modes m, low < m <= high, at which the topology of the mode surface of the piecewise linear
/// field changes. (The level at m is that of modes just above.)
///
/// The mode is smooth on each vertex, edge, face and tetrahedron where there is one, so by
/// stratified Morse theory (M. Goresky and R. MacPherson, 1988) the level only moves where no m is
/// the value at a critical point of one of these; and what happens there follows from the link of
/// the point (`local_effect`). Where the mode is undefined it is constant along rays, and the
/// critical points on other simplices stand for all.
/// @param mesh  valid
/// The result does not depend on the number of threads.
MeshCriticalValues mesh_critical_values(const TetMesh& mesh, double low, double high);

}  // namespace tensortopo
