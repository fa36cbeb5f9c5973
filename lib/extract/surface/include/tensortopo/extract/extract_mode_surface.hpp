// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/extract/level_topology.hpp"
#include "tensortopo/extract/meshing_message.hpp"
#include "tensortopo/extract/prepared_field.hpp"
#include "tensortopo/extract/unresolved_reason.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// A tetrahedron that no proof covers, and that is left out.
struct UnresolvedCell {
  TetMesh::Index tet;       ///< position in the mesh
  UnresolvedReason reason;  ///< why
};

/// What the extraction did, for reports.
struct ExtractStatistics {
  std::size_t tets_screened_out = 0;  ///< proved empty by Lode angles or the degree-six form
  std::size_t tets_crossed = 0;       ///< hold triangles
  std::size_t tets_monotone = 0;      ///< crossed, and one monotone disc each
  std::size_t tets_refined = 0;       ///< needed a refinement for the proof
  std::size_t tets_coned = 0;         ///< crossed, and have an isotropic vertex
  std::size_t tets_undefined = 0;     ///< isotropic at all four vertices: no mode, no surface
  std::size_t sheets_small = 0;       ///< meshed without inner samples
  std::size_t sheets_bisected = 0;    ///< meshed by bisection of edges, see `MeshingMethod::bisection`
  std::size_t sheets_tubes = 0;       ///< meshed as rings around the degenerate curve
  std::size_t sheets_graph = 0;       ///< meshed as graphs
  std::size_t sheets_manifold = 0;    ///< meshed on the medium eigenvector manifold
  std::size_t sheets_dominant = 0;    ///< meshed by their dominant eigenvectors
  std::size_t sheets_subdivision = 0;  ///< meshed from the proof's subdivision
  std::size_t sheets_loops =
      0;  ///< meshed between their boundary loops, as nothing else was possible
  std::size_t sheets_cones = 0;       ///< straight lines from isotropic vertices
  std::size_t tets_nearby = 0;        ///< meshed at a level next to mu, which stands for mu + 0
  std::size_t vertices_on_level = 0;  ///< vertices whose mode is exactly mu (counted as below)
  std::size_t zero_deviator_vertices = 0;  ///< isotropic vertices of tetrahedra
  std::size_t cone_points = 0;             ///< vertices of the surface there, one for each fan
  /// Time of each stage, in seconds.
  double seconds_edges = 0, seconds_faces = 0, seconds_tets = 0, seconds_stitch = 0;
};

/// An extracted surface, and what is known of it.
struct Extraction {
  SurfaceMesh surface;                     ///< the triangles
  std::vector<UnresolvedCell> unresolved;  ///< what is left out, ascending
  /// Tetrahedra whose triangles have the proved topology, but intersect each other or are at 90
  /// degrees to the gradient of the mode or more.
  std::vector<TetMesh::Index> not_embedded;
  LevelTopology topology;                  ///< if asked for
  std::vector<MeshingMessage> messages;    ///< between parts, see `ExtractOptions`; ascending
  ExtractStatistics statistics;            ///< what was done
};

/// The mode surface {mode = mu} of the piecewise linear field, |mu| < 1: for mu = 0 the neutral
/// surface.
///
/// Its topology in every edge, face and tetrahedron is decided by proofs on exact signs, not by
/// samples; the level is mu + 0 where a vertex lies on mu. Vertices are shared by construction:
/// each carries the edge, face or tetrahedron that it lies in.
/// Tetrahedra for which no proof closes are listed, and the rest is extracted.
///
/// Where mu is a critical value of the mode in a tetrahedron, a face or an edge, a level next to mu
/// is meshed for mu + 0, off by 2^-40 of the distance from mu to +-1 or less: it is proved that
/// there is no critical value in between. Points on either side of a saddle are then about 2^-20 of
/// the tetrahedron apart.
///
/// At an isotropic vertex z of the mesh the mode is undefined, and in a tetrahedron around it
/// constant on each ray from z: the level there is the cone with apex z over the level on the
/// opposite face; with a second such vertex y, the flat triangles from the edge zy to the crossings
/// of the opposite edge. Fans of triangles that meet at z in nothing but the point have a vertex
/// each there (`Carrier::vertex`, several at one place), so the surface is a manifold. Along zy two
/// triangles are joined, at a vertex halfway, if they bound one stretch of larger modes around the
/// edge. The surface ends at such an edge only where a face there has no deviator at all, or at
/// the boundary of the mesh or of what is unresolved.
///
/// @tparam Scalar  double; 50 digits are for tests only, and not installed
/// @pre the mesh is valid (see `validate`, which the caller has to ask: nothing else does)
/// @throws std::invalid_argument for modes that no double tells from 1 or -1, and as
///         `require_fitting`
/// The result does not depend on the number of threads. But for the numbers of the mesh's vertices
/// and tetrahedra that it names, it does not depend on these, nor on the order of corners: vertices
/// and triangles are in the canonical order (see `CanonicalMesh`) of the simplices that hold them.
template <class Scalar>
Extraction extract_mode_surface(const TetMesh& mesh, const ModeValue& mu,
                                const ExtractOptions& options = {});

/// The same surface, for several modes of one mesh: what does not depend on the mode is computed
/// once.
template <class Scalar>
Extraction extract_mode_surface(const PreparedField<Scalar>& field, const ModeValue& mu,
                                const ExtractOptions& options = {});

/// The same for the last of the modes: parts of the field are given back once they have been read.
template <class Scalar>
Extraction extract_mode_surface(PreparedField<Scalar>&& field, const ModeValue& mu,
                                const ExtractOptions& options = {});

}  // namespace tensortopo
