// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What was proved of a level, taken apart by tetrahedra and put together again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/extract/level_topology.hpp"
#include "tensortopo/partition/mesh_piece.hpp"

namespace tensortopo {

/// Calls f for each vertex of the surface that a topology names, but for `copies`.
/// @param topology  const or not
template <class Topology, class F>
void for_each_surface_vertex(Topology& topology, const F& f) {
  for (auto& edge : topology.edges)
    for (auto& crossing : edge.crossings)
      if (crossing.vertex >= 0) f(crossing.vertex);
  for (auto& face : topology.faces) {
    for (auto& arc : face.arcs) f(arc[0]), f(arc[1]);
    for (auto& v : face.loops) f(v);
  }
  for (auto& tet : topology.tets)
    for (auto& sheet : tet.sheets)
      for (auto& loop : sheet.loops)
        for (auto& arc : loop) f(arc.from);
  for (auto& cone : topology.cones)
    for (auto& sheet : cone.sheets)
      for (auto& v : sheet) f(v);
}

/// What it says of the tetrahedra that a piece owns, with their faces and edges; without copies.
/// @param topology  of the piece's mesh
LevelTopology topology_of_owned(LevelTopology topology, const MeshPiece& piece);

/// Gives vertices and tetrahedra of the mesh other numbers, in the same order.
void renumber_mesh(LevelTopology& topology, std::span<const TetMesh::Index> vertices,
                   std::span<const TetMesh::Index> tets);

/// One of the parts of a topology, and what its numbers are in the whole.
struct TopologyPart {
  using Index = TetMesh::Index;
  const LevelTopology* topology = nullptr;
  std::vector<Index> vertices, tets;    ///< of the mesh, in the same order
  std::vector<Index> surface_vertices;  ///< of the surface
};

/// The parts as one. What several parts say of an edge or face has to be the same.
/// @param vertex_ids  of the whole's vertices, for messages
/// @throws PiecesDiffer
LevelTopology merge_topologies(std::span<const TopologyPart> parts,
                               std::span<const std::int64_t> vertex_ids);

}  // namespace tensortopo
