// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/stability/uncertain_field.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Whether the topology of a level in a tetrahedron is the same for all members of an uncertain
/// field; if not, what is the first thing that is not proved.
enum class Stability : std::uint8_t {
  stable,
  isotropic_within_radius,  ///< a vertex' deviator is not larger than its radius
  side_of_vertex,           ///< a vertex is on different sides for different members
  crossings_of_edge,        ///< not proved to be the same on an edge
  curves_of_face,           ///< not proved to be the same on a face
  sheets_of_tet,            ///< not proved to be the same inside
  unresolved,               ///< left out by the extraction
};

/// The name that reports use.
std::string_view name_of(Stability stability);

/// What holds of one level.
struct LevelStability {
  std::vector<Stability> tets;  ///< one per tetrahedron of the mesh
};

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

/// Marks what an extraction left out.
void mark_unresolved(std::span<const UnresolvedCell> unresolved, LevelStability& stability);

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

}  // namespace tensortopo
