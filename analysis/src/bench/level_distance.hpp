// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Distances of samples of a surface, weighed by area.
struct Spread {
  double area = 0, squares = 0;  ///< of the samples; area times squared distance
  double largest = 0;
  std::size_t samples = 0;
  double root_mean_square() const;
  Spread& operator+=(const Spread& other);
};

/// How far a surface and the level {mode = mu} are from each other, estimated.
///
/// To the level: from three places in each triangle, (2/3, 1/6, 1/6) and its turns, which integrate
/// squares exactly, by Newton's method along the gradient to the level of the linear field in the
/// triangle's tetrahedron. Where the foot lies outside the tetrahedron, or there is none, to the
/// nearest triangle of the reference. From the level: from the middles of the reference's
/// triangles, moved onto the level in the same way where the foot is inside, to the nearest
/// triangle of the surface. Both estimates are at most second order in the distance away from it;
/// the reference's own distance from the level (measured in the same way) limits the second one.
struct LevelDistance {
  Spread to_level, from_level;
  std::size_t not_projected = 0;  ///< samples whose foot was not found inside
  /// Two-sided: the larger of the two root mean squares. Infinite if one of the two surfaces is
  /// empty and the other is not.
  double root_mean_square() const;
  double largest() const;
  LevelDistance& operator+=(const LevelDistance& other);
};

/// @param mesh,surface   the surface's `tet` are tetrahedra of this mesh
/// @param reference_mesh,reference  a fine extraction of the same level, and its mesh: the same
///           field
LevelDistance level_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             const TetMesh& reference_mesh, const SurfaceMesh& reference,
                             const ModeValue& mode);

}  // namespace tensortopo
