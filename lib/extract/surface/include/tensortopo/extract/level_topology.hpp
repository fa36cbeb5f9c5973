// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// What the extraction proved of the level, in terms of the surface that it drew: the crossings of
/// each edge, the curves of each face, the sheets of each tetrahedron. What is not listed is proved
/// to be empty, except in tetrahedra that are unresolved.
struct LevelTopology {
  using Index = TetMesh::Index;       ///< of the mesh
  using Vertex = SurfaceMesh::Index;  ///< of the surface

  /// A crossing of an edge.
  struct Crossing {
    /// Of the two vertices among the scaled tensors, see `ScaledField`; the sum is 1 but for
    /// rounding.
    std::array<double, 2> weights{};
    bool rising = false;  ///< the mode passes mu upwards from the first vertex to the second
    Vertex vertex = -1;   ///< of the surface
  };
  /// An edge with its crossings.
  struct Edge {
    std::array<Index, 2> vertices{};  ///< ascending
    std::vector<Crossing> crossings;  ///< in order from the first vertex
  };
  /// A face with its curves.
  struct Face {
    std::array<Index, 3> vertices{};          ///< ascending
    std::vector<std::array<Vertex, 2>> arcs;  ///< between crossings, ascending
    std::vector<Vertex> loops;                ///< the smallest vertex of each closed curve
  };
  /// An arc of a sheet's boundary: from a crossing, in the face opposite a vertex of the
  /// tetrahedron, to the next one's crossing. A closed curve is one arc, from its smallest vertex.
  struct BoundaryArc {
    Vertex from = -1;     ///< the crossing where it begins
    Index opposite = -1;  ///< a vertex of the mesh
    /// By vertex, then by face.
    auto operator<=>(const BoundaryArc&) const = default;
  };
  /// A connected part of the level in a tetrahedron.
  struct Sheet {
    int euler_characteristic = 0;  ///< of the sheet with its boundary
    /// Directed as the triangles' boundary; each from its smallest vertex; in order of those.
    std::vector<std::vector<BoundaryArc>> loops;
  };
  /// A tetrahedron with its sheets.
  struct Tet {
    Index tet = -1;             ///< position in the mesh
    std::vector<Sheet> sheets;  ///< all that it has
  };
  /// A sheet of a tetrahedron with isotropic vertices, a disc, in the order of its
  /// triangles' boundary. With one such vertex it is the cone over an arc of the opposite face,
  /// {from, to, tip}, or over a closed curve of it, {smallest vertex, tip}; with two the join of
  /// them with a crossing of the opposite edge, {crossing, tip, halfway, other tip}.
  using ConeSheet = std::vector<Vertex>;
  /// A tetrahedron with isotropic vertices, and its sheets.
  struct Cone {
    Index tet = -1;                 ///< position in the mesh
    std::vector<ConeSheet> sheets;  ///< ascending
  };

  std::vector<Edge> edges;  ///< those with crossings, in order of their vertices
  std::vector<Face> faces;  ///< those with curves, in order of their vertices
  std::vector<Tet> tets;    ///< those with sheets and a deviator at each vertex, ascending
  std::vector<Cone> cones;  ///< those with sheets and an isotropic vertex, ascending
  /// A crossing's vertex, and another at the same place: where parts of the surface meet in a
  /// crossing only, each but the first has such a copy for itself. All else is in terms of
  /// `vertex`.
  std::vector<std::array<Vertex, 2>> copies;
};

}  // namespace tensortopo
