// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The topology of a level in a mesh, derived from the field alone.
#pragma once

#include <compare>
#include <vector>

#include "field.hpp"
#include "places.hpp"
#include "tet_level.hpp"

namespace certificate {

using Vertex = std::uint32_t;

/// A crossing of an edge of the mesh: which edge, which of its crossings.
struct MeshCrossing {
  std::array<Vertex, 2> edge{};
  unsigned ordinal = 0;

  auto operator<=>(const MeshCrossing&) const = default;
};

struct EdgeTopology {
  std::array<Vertex, 2> vertices{};
  EdgeLevel level;

  bool is_decided() const { return level.decided; }
  bool is_crossed() const { return level.crossings > 0; }
};
struct FaceTopology {
  std::array<Vertex, 3> vertices{};
  FaceLevel level;
  std::vector<std::array<MeshCrossing, 2>> arcs;  ///< as in `level`

  bool is_decided() const { return level.decided; }
  bool is_crossed() const { return !arcs.empty() || !level.loops.empty(); }
};
/// A boundary loop: from crossing to crossing, through faces named by their opposite vertices.
/// A closed curve has no crossings, and is that many-th of its face.
struct MeshLoop {
  struct Step {
    MeshCrossing from;
    Vertex opposite;
  };
  std::vector<Step> steps;
  Vertex opposite = 0;
  std::size_t curve = 0;
};
struct MeshSheet {
  long euler_characteristic = 0;
  std::vector<MeshLoop> loops;
  bool above_inside = false;  ///< of a sheet without loops: what it encloses is above
};
struct TetTopology {
  std::uint32_t tet = 0;  ///< among the tetrahedra of the input
  bool decided = false;
  Proved<4> proved;
  std::vector<MeshSheet> sheets;

  bool is_decided() const { return decided; }
  bool is_crossed() const { return !sheets.empty(); }
};

/// A sheet of a cone: over an arc or, without crossings, a closed curve (by number) of the face
/// opposite its one tip, or from its two tips to the one crossing of the edge opposite them; in the
/// order in which the triangles have it as their boundary.
struct ConeSheet {
  std::vector<MeshCrossing> crossings;
  std::vector<Vertex> tips;
  std::size_t curve = 0;
};
/// A tetrahedron with one or two vertices of zero deviator, its tips, from which the mode is
/// constant along rays.
struct ConeTopology {
  std::uint32_t tet = 0;
  bool decided = false;
  std::vector<Vertex> base, tips;  ///< its vertices
  std::vector<ConeSheet> sheets;

  bool is_decided() const { return decided; }
  bool is_crossed() const { return !sheets.empty(); }
};

/// What holds in all tetrahedra but those left out. Edges, faces and tetrahedra that are not
/// listed do not hold the level; the lists ascend.
struct Topology {
  std::vector<char> above;  ///< for each vertex of the mesh
  std::size_t on_level = 0;
  std::vector<EdgeTopology> edges;
  std::vector<FaceTopology> faces;
  std::vector<TetTopology> tets;
  std::vector<ConeTopology> cones;  ///< with two tips: those without the level as well

  const EdgeTopology* edge(const std::array<Vertex, 2>& vertices) const;
  const FaceTopology* face(const std::array<Vertex, 3>& vertices) const;
  const TetTopology* tet(std::size_t tet) const;    ///< null if there is none
  const ConeTopology* cone(std::size_t tet) const;  ///< null if there is none
};

/// The result does not depend on the order in which `for_all` and `for_some` call.
/// @param left_out tetrahedra of which nothing is asked
/// @param for_some  may leave calls out, which leaves undecided what they would tell
Topology derive_topology(const Input& input, const Field& field, const Level& level,
                         const std::vector<bool>& left_out, const ForAll& for_all,
                         const ForAll& for_some);

/// The sign of the volume of a tetrahedron in the order of its vertices.
int orientation(const Input& input, const std::array<Vertex, 4>& tet);

}  // namespace certificate
