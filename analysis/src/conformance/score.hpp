// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "conformance/given_surface.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A certified surface to compare with: its claims and its triangles.
struct Standard {
  SurfaceMesh surface;
  CertifiedLevel level;
};

/// Extracts and certifies. A finer resolution brings the triangles closer to the level.
Standard certified_standard(const TetMesh& mesh, const ModeValue& mode, double resolution);

/// A component of the standard or of the given surface.
struct ScoredComponent {
  long euler_characteristic = 0;
  long boundary_loops = 0;
  std::size_t triangles = 0;
  Vector3<double> place;  ///< a point of it
};

struct MatchedComponent {
  ScoredComponent truth, given;
  std::size_t shared_crossings = 0;  ///< crossings of mesh edges that both have
  bool same_topology() const {
    return truth.euler_characteristic == given.euler_characteristic &&
           truth.boundary_loops == given.boundary_loops;
  }
};

struct EdgeScore {
  std::array<TetMesh::Index, 2> vertices{};
  int truth = 0, given = 0;
};

/// What is wrong with a surface that claims to be the level's.
struct SurfaceScore {
  std::size_t triangles = 0, merged_points = 0, collapsed_triangles = 0;
  std::size_t other_modes = 0;  ///< triangles of the file that are of other modes

  std::vector<MatchedComponent> matched;
  std::vector<ScoredComponent> missed, extra;
  /// True components that are not there, and whose triangles have no extent to speak of: a level
  /// that runs through a vertex of the mesh exactly, and is mu + 0 only beside it.
  std::size_t without_extent = 0;

  std::size_t hole_edges = 0;  ///< edges with one triangle where the level does not end
  std::size_t holes = 0;       ///< connected pieces of them
  std::size_t seam_edges = 0;  ///< coincident edges whose vertices are not one
  std::size_t non_manifold_edges = 0, non_manifold_vertices = 0;
  bool consistently_oriented = true;

  std::size_t crossings = 0;     ///< of mesh edges with the level, certified
  std::vector<EdgeScore> edges;  ///< those on which the given count is another
  std::size_t missed_crossings = 0, extra_crossings = 0;
  std::size_t unclear_edges = 0;  ///< crossings too close to each other or to a vertex to compare

  double to_truth = 0;    ///< largest distance of a sample of the given surface from the standard
  double from_truth = 0;  ///< and the other way round; infinite if the given surface is empty
  /// Certified bound on the distances between the standard and the level, both ways: add it. In
  /// `coarse_cells` tetrahedra only `coarse_bound` is certified.
  double certified = 0, coarse_bound = 0;
  std::size_t coarse_cells = 0;
  std::size_t undecided = 0;  ///< tetrahedra about which there is no truth

  std::size_t wrong_topology() const;
  /// Topology, crossings and connectivity are all right; distances are not judged.
  bool conforms() const;
};

struct ScoreOptions {
  /// Two points are one, for seams, holes and crossings, within this part of a mesh edge (or the
  /// rounding of float32 coordinates, if that is more).
  double touch = 1e-6;
};

/// Compares a given surface with the standard.
///
/// Components are matched if most of each, by area, is nearest to the other and nearer than the
/// longest edge of the mesh's tetrahedron there, and if they share a crossing of a mesh edge
/// (should the true one have any). Distances are sampled: at each vertex, edge midpoint and
/// centroid of the triangles.
SurfaceScore score_surface(const TetMesh& mesh, const Standard& standard, GivenSurface given,
                           const ScoreOptions& options = {});

}  // namespace tensortopo
