// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "support/surfaces/topology.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// What one level of a certificate claims about topology, without positions, names of vertices of
/// the surface, and everything else that depends on how it was meshed.
struct ClaimedTopology {
  using Index = TetMesh::Index;
  std::map<std::array<Index, 2>, int> crossings;
  std::map<std::array<Index, 3>, std::array<int, 2>> curves;      ///< arcs and closed curves
  std::map<std::array<Index, 4>, std::vector<ComponentTopology>> sheets;  ///< of tetrahedra
  std::map<std::array<Index, 4>, int> cones;
  std::vector<ComponentTopology> components;                      ///< of the surface
  std::map<std::array<Index, 4>, std::string> undecided;          ///< with reasons
  int on_level = 0;                                               ///< vertices on the level

  friend bool operator==(const ClaimedTopology&, const ClaimedTopology&) = default;
};

/// @param level  an entry of a certificate's "levels"
/// @param to     new numbers of the vertices of the mesh; empty for those that they have
ClaimedTopology claimed_topology(const nlohmann::json& level, const TetMesh& mesh,
                                 const std::vector<TetMesh::Index>& to = {});

/// What differs, in lines, for failure messages.
std::string difference(const ClaimedTopology& a, const ClaimedTopology& b);

}  // namespace tensortopo::test
