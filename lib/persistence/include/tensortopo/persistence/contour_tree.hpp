// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo {

/// A point at which components of level sets of the mode appear, vanish, join or part: a local
/// extremum, or a point at which components of {mode >= m} or of {mode <= m} meet.
struct ContourNode {
  ModeRange mode;  ///< encloses the point's
  /// In the merge tree of the mode, or its opposite.
  std::optional<std::size_t> maximum, minimum;
  std::optional<std::size_t> point;  ///< critical point; none for curves and degenerate vertices
  TetMesh::Index tet = -1;           ///< one that it is in
  Vector3<double> place{};           ///< about where
  /// A maximum that is in the same component of {mode >= m}, m the node's mode, and a minimum in
  /// the same component of {mode <= m}; one of several at points where components meet.
  std::optional<std::size_t> above, below;
};

/// The contour tree of the mode.
///
/// Its points are the connected components of the level sets of the mode. A component of the
/// surface of mode m, m no critical value, is an arc that goes from a node above m to one below.
struct ContourTree {
  std::vector<ContourNode> nodes;                ///< by falling mode
  std::vector<std::array<std::size_t, 2>> arcs;  ///< upper and lower node
  /// Each node and each arc is proved, but for the order of nodes whose enclosures overlap.
  bool is_complete = true;
  /// The mesh has loops that bound nothing in it, so that the Reeb graph may not be a tree; then
  /// there are no arcs.
  bool has_loops = false;

  /// Arcs from above a mode to below it.
  std::vector<std::size_t> arcs_across(double mode) const;
};

/// By the algorithm of H. Carr, J. Snoeyink and U. Axen (Computing contour trees in all dimensions,
/// 2003), from both merge trees and a path from each node of one to an extremum of the other.
/// Points that are not proved to join components are no nodes.
ContourTree contour_tree(const TetMesh& mesh, const PersistenceInput& input);

}  // namespace tensortopo
