// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "homology/curve_shape.hpp"
#include "tensortopo/persistence/merge_tree.hpp"

namespace tensortopo::persistence {

/// How the components of {mode >= m} come and meet as m falls, together with what is outside of the
/// mesh: the boundary surfaces are components that are there from the start.
struct OutsideTree {
  /// Its first maxima stand for the boundary surfaces and have modes above 1; the maxima of the
  /// mesh's merge tree follow. Each merge is one with the same parts of the link as there, those
  /// that touch the boundary put in the place of its surface.
  MergeTree tree;
  std::size_t surfaces = 0;  ///< how many maxima are boundary surfaces
  /// Of each merge the component of curves that meets the boundary in several places; others are at
  /// critical points.
  std::vector<std::optional<std::size_t>> curves;
  /// Of each maximum of the merge tree what stands for it: itself, or the boundary surface that it
  /// is on, so that it bears no component.
  std::vector<std::size_t> member;
  /// Whether it is the latter.
  bool is_outside(std::size_t maximum) const { return member[maximum] < surfaces; }
};

/// @param tree  of the mesh, its critical points and curves
/// @param shapes  of the curves
OutsideTree outside_tree(const MergeTree& tree, const MeshCriticalValues& values,
                         const std::vector<CurveShape>& shapes, const MeshBoundary& boundary);

}  // namespace tensortopo::persistence
