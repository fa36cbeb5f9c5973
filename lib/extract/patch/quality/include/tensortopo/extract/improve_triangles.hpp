// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Angles of a surface, in degrees: of each triangle the least one, at most 60.
struct AngleSummary {
  double least = 60;  ///< the least of all
  double mean = 60;   ///< the mean over the triangles
};

/// What `improve_triangles` did.
struct ImprovementCounts {
  std::size_t flipped = 0;            ///< edges inside tetrahedra
  std::size_t moved_in_tets = 0;      ///< steps of vertices inside tetrahedra, along the level
  std::size_t moved_along_faces = 0;  ///< steps of vertices inside faces, along their curve
  AngleSummary before;  ///< of the surface as it was
  AngleSummary after;   ///< of the surface now
};

/// Better angles for an extracted surface: edges inside tetrahedra are flipped, vertices inside
/// tetrahedra move along the level and those inside faces of the mesh along their curve, where
/// that enlarges the least angle of the triangles around.
///
/// Laws      (1) every vertex stays in the edge, face or tetrahedron that holds it, those on edges
///           and vertices of the mesh stay where they are; triangles stay in their tetrahedra, with
///           the same directed boundary loops on each face, and no two boundary loop vertices of
///           one face get an edge beside the boundary loop; so all invariants are kept, of each
///           tetrahedron's sheets and of the whole; (2) the least angle does not shrink; (3) by the
///           first-order distance at centroids, the mean square distance to the level does not
///           grow; (4) the result does not depend on the number of threads.
/// Cost      some rounds over the surface, on one thread.
/// @param surface  extracted from this mesh at this mode; normals, eigenvectors and residuals of
///                 vertices that move are computed anew
ImprovementCounts improve_triangles(const TetMesh& mesh, const ModeValue& mode,
                                    SurfaceMesh& surface, int rounds = 6);

}  // namespace tensortopo
