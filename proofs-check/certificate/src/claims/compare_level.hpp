// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Claims about edges, faces and tetrahedra against what was derived of them.
#pragma once

#include <map>
#include <set>
#include <unordered_map>

#include "claims/compare_list.hpp"
#include "files/files.hpp"
#include "topology.hpp"

namespace certificate {

struct Range {
  Number first = 0, count = 0;
};
inline Range range_of(const Json& value) {
  return {value[0].get<Number>(), value[1].get<Number>()};
}

/// The closed curves of faces that have several, by the vertices that the certificate names them by.
struct CurveNames {
  std::map<std::array<Vertex, 3>, std::vector<Number>> names;  ///< in the order of the curves
  std::set<std::array<Vertex, 3>> uncertain;   ///< where places do not tell which is which
};

/// One level of a certificate beside the truth about it.
struct LevelCase {
  const Input& input;
  const Field& field;
  const Level& level;
  const Triangles& surface;
  const Json& claims;
  Range vertices, triangles;           ///< of the level, in the surface
  const std::vector<bool>& left_out;   ///< tetrahedra about which nothing is claimed
  const Topology& topology;
  const Progress& progress;
  CurveNames curves;
};

/// Which vertex of the surface is which crossing, as the certificate claims.
struct CrossingVertices {
  struct Hash {
    std::size_t operator()(const MeshCrossing& c) const {
      const std::uint64_t key = std::uint64_t{c.edge[0]} << 32 | c.edge[1];
      return (key ^ key >> 29) * 0x9e3779b97f4a7c15U + c.ordinal;
    }
  };
  std::unordered_map<MeshCrossing, Number, Hash> vertex;
  std::unordered_map<Number, MeshCrossing> crossing;   ///< copies too
  std::unordered_map<Number, Number> original;         ///< of a copy: the crossing's first vertex
};

CrossingVertices compare_edges(const LevelCase& c, Ledger& ledger);
void compare_faces(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger);
void compare_tets(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger);
void compare_cones(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger);

/// Is this vertex of the surface one of the level, and lies at a vertex of the mesh?
bool is_at(const LevelCase& c, const Json& vertex, Vertex place);

}  // namespace certificate
