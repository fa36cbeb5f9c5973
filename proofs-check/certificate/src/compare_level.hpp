// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Claims about edges, faces and tetrahedra against what was derived of them.
#pragma once

#include <map>
#include <unordered_map>

#include "claims.hpp"
#include "ledger.hpp"
#include "topology.hpp"

namespace certificate {

/// Which vertex of the surface is which crossing, as the certificate claims.
struct CrossingVertices {
  std::map<MeshCrossing, Number> vertex;
  std::unordered_map<Number, MeshCrossing> crossing;
};

/// One level of a certificate beside the truth about it.
struct LevelCase {
  const Input& input;
  const Field& field;
  const Level& level;
  const Triangles& surface;
  const LevelClaims& claims;
  const Topology& topology;
};

CrossingVertices compare_edges(const LevelCase& c, Ledger& ledger);
void compare_faces(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger);
void compare_tets(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger);

}  // namespace certificate
