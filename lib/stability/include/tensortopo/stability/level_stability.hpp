// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/stability/uncertain_field.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Whether the topology of a level, or of degenerate curves, in a tetrahedron is the same for all
/// members of an uncertain field; if not, what is the first thing that is not proved.
enum class Stability : std::uint8_t {
  stable,
  isotropic_within_radius,  ///< a vertex' deviator is not larger than its radius
  side_of_vertex,           ///< a vertex is on different sides for different members
  crossings_of_edge,        ///< not proved to be the same on an edge
  curves_of_face,           ///< not proved to be the same on a face
  sheets_of_tet,            ///< not proved to be the same inside
  unresolved,               ///< left out by the extraction
  degenerate_vertex,        ///< some members are degenerate in a vertex
  degenerate_edge,          ///< not proved that no member is degenerate on an edge
  points_of_face,           ///< degenerate points not proved to be the same on a face
  arcs_of_tet,              ///< curves not proved to be the same inside
};

/// The name that reports use.
std::string_view name_of(Stability stability);

/// All numbers with their names: "0 stable, 1 isotropic_within_radius, ...".
std::string stability_names();

/// An edge or a face that is not proved to be crossed alike by all members, and why.
template <std::size_t Vertices>
struct UnstableSimplex {
  std::array<TetMesh::Index, Vertices> vertices{};  ///< ascending
  Stability reason = Stability::unresolved;         ///< the first thing that is not proved
};

/// What holds of one level, or of degenerate curves of one kind.
struct LevelStability {
  std::vector<Stability> tets;  ///< one per tetrahedron of the mesh
  /// Edges and faces, by their vertices in ascending order, that may be crossed and are proved to
  /// be crossed alike by all members; ascending.
  std::vector<std::array<TetMesh::Index, 2>> stable_edges;
  std::vector<std::array<TetMesh::Index, 3>> stable_faces;  ///< as `stable_edges`
  /// Those of them that a certificate claims: proved for larger radii, so that another derivation
  /// closes as well.
  std::vector<std::array<TetMesh::Index, 2>> claimed_edges;
  std::vector<std::array<TetMesh::Index, 3>> claimed_faces;  ///< as `claimed_edges`
  /// The others that may be crossed, by vertices.
  std::vector<UnstableSimplex<2>> unstable_edges;
  std::vector<UnstableSimplex<3>> unstable_faces;  ///< as `unstable_edges`
};

/// Whether all members cross the edge, or face, of a vertex of a surface, or of curves, alike; if
/// not, why. The vertex then is a crossing that each member has, with the same place in their order
/// along the edge.
/// @param vertices  ascending
Stability crossing_stability(const LevelStability& stability,
                             const std::array<TetMesh::Index, 2>& vertices);
/// The same of a degenerate point on a face: each member has as many.
Stability crossing_stability(const LevelStability& stability,
                             const std::array<TetMesh::Index, 3>& vertices);

/// The tetrahedra in which the level {mode = mu} is the same, up to homeomorphism, for all members.
///
/// Proved of a tetrahedron that is stable: for no member its field has in a vertex, an edge, a face
/// or the inside a point of mode mu at which all derivatives along that simplex vanish, nor a zero.
/// The members are a convex set, so by Thom's first isotopy lemma there is for any two of them
/// a homeomorphism of the tetrahedron that takes one level to the other and keeps each face, edge
/// and vertex. So whatever the extraction proved of the level there holds for each member: the
/// number of crossings of each edge, the curves of each face and how they join crossings, the
/// sheets with their boundaries and Euler characteristics. Tetrahedra that have no part of the
/// level are stable if none has for any member.
///
/// `isotropic_within_radius` and `side_of_vertex` are exact, up to rounding: there are members that
/// differ. The other reasons are: no proof within the budget.
///
/// @pre |mu| < 1
/// The result does not depend on the number of threads.
/// @param options  its `progress` only
LevelStability level_stability(const UncertainField& field, const ModeValue& mu,
                               const ExtractOptions& options = {});

/// The tetrahedra in which the degenerate curves of one kind are the same, up to homeomorphism, for
/// all members.
///
/// Proved of a tetrahedron that is stable: no member has a zero in it; none is degenerate, of this
/// kind, on an edge; and wherever one is degenerate, in a face or inside, it crosses the degenerate
/// tensors transversally there, in the face too. As above, any two members have a homeomorphism of
/// the tetrahedron that takes one's curves to the other's and keeps each face, edge and vertex. So
/// all have the same number of degenerate points on each face, and as many arcs that join them, and
/// closed curves inside.
///
/// `isotropic_within_radius` and `degenerate_vertex` are exact, up to rounding.
/// The result does not depend on the number of threads.
/// @param options  its `progress` only
LevelStability curve_stability(const UncertainField& field, Degeneracy kind,
                               const ExtractOptions& options = {});

/// Marks what an extraction left out.
void mark_unresolved(std::span<const UnresolvedCell> unresolved, LevelStability& stability);
void mark_unresolved(std::span<const UnresolvedCurve> unresolved, LevelStability& stability);

/// By component of a surface or of curves, from the tetrahedron and the component of each triangle
/// or line: whether one of these is in a tetrahedron given, or in one that has a face in common
/// with it.
std::vector<char> components_beside(const TetMesh& mesh, const std::vector<TetMesh::Index>& tets,
                                    const std::vector<TetMesh::Index>& components,
                                    const std::vector<TetMesh::Index>& left_out);

/// What stable tetrahedra make of a surface.
struct SurfaceStability {
  std::vector<char> triangles;  ///< its tetrahedron is stable
  /// By component: all its tetrahedra are stable, and none has a face in common with one that was
  /// left out. Then each member has a component that is homeomorphic to it, by a map that keeps
  /// each tetrahedron, face and edge: the tetrahedra's homeomorphisms agree on common faces, and
  /// the component leaves their union nowhere but at the mesh's boundary.
  std::vector<char> components;
};

SurfaceStability surface_stability(const TetMesh& mesh, const SurfaceMesh& surface,
                                   const LevelStability& stability);

/// By component of degenerate curves: all its tetrahedra are stable, and none has a face in common
/// with one that was left out. As of a surface, each member has a component that is homeomorphic to
/// it, by a map that keeps each tetrahedron, face and edge.
std::vector<char> stable_curves(const TetMesh& mesh, const CurveMesh& curves,
                                const LevelStability& stability);

}  // namespace tensortopo
