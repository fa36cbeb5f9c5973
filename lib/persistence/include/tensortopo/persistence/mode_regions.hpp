// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/persistence/contour_tree.hpp"

namespace tensortopo {

/// A component of what the neutral surface leaves of the field: all modes in it have one sign.
struct ModeRegion {
  int sign = 1;                     ///< of the modes: 1 or -1
  std::vector<std::size_t> nodes;   ///< of the contour tree
  std::vector<std::size_t> curves;  ///< components of the degenerate curves of mode 1 (or -1)
};

/// A component of the neutral surface, and the regions on its sides.
struct RegionBorder {
  /// Places in `ModeRegions::regions`.
  std::size_t positive = 0, negative = 0;
};

/// Degenerate curves, the regions that hold them, and which of these are neighbours: the
/// topological graph of S.-H. Hung, Y. Zhang and E. Zhang (Global topology of 3D symmetric tensor
/// fields, 2023).
struct ModeRegions {
  std::vector<ModeRegion> regions;    ///< in the order of their first nodes
  std::vector<RegionBorder> borders;  ///< one for each component of the neutral surface
  bool is_complete = true;            ///< the tree is, and no node may have mode 0
};

/// What is left of the contour tree where mode 0 is taken out. Nothing, and not complete, if the mesh
/// has loops: then there is no tree.
ModeRegions mode_regions(const ContourTree& tree, const PersistenceInput& input);

/// The lines of a component of curves that is one closed line, in order; nothing of others.
std::optional<std::vector<std::size_t>> lines_of_closed(const CurveMesh& curves,
                                                        std::size_t component);

/// The vertices of a component of curves that is one closed line, in order, each once; nothing of
/// other components.
std::optional<std::vector<CurveMesh::Index>> closed_line(const CurveMesh& curves,
                                                         std::size_t component);

}  // namespace tensortopo
