// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tensortopo/extract/level_topology.hpp"

namespace tensortopo {

/// A topology as plain numbers, which processes can send to each other.
struct TopologyNumbers {
  std::vector<std::int32_t> integers;  ///< lists, each after its length
  std::vector<double> weights;         ///< of the crossings of edges, two each
};

/// All but `copies`.
/// Law       `topology_of(numbers_of(t), ...)` is t without its copies.
TopologyNumbers numbers_of(const LevelTopology& topology);

/// What the numbers of a topology count.
struct TopologyCounts {
  std::size_t mesh_vertices = 0;     ///< points of the mesh
  std::size_t tets = 0;              ///< its tetrahedra
  std::size_t surface_vertices = 0;  ///< vertices of the surface
};

/// @throws std::invalid_argument unless the numbers are those of a topology, and each is below what
///         it counts; memory is in proportion to the numbers
LevelTopology topology_of(const TopologyNumbers& numbers, const TopologyCounts& counts);

}  // namespace tensortopo
