// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyze/curvature/level_curvature.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A point inside a triangle where the principal curvatures agree.
struct Umbilic {
  std::size_t triangle = 0;
  Vector3<double> point{};
  double curvature = 0;  ///< both of them
  /// Twice the index of the principal directions: 1 for a wedge (or, among umbilics, a lemon or
  /// monstar), -1 for a trisector (star).
  int twice_index = 0;
};

struct SurfaceCurvature {
  /// One a vertex of the surface; nothing where it is undefined.
  std::vector<std::optional<LevelCurvature<double>>> vertices;
  /// The largest angle, in radians, between a vertex' normal and the normals in the tetrahedra that
  /// meet there: how far the surface is from smooth. 0 inside a tetrahedron.
  std::vector<double> normal_jump;
  std::vector<Umbilic> umbilics;  ///< by triangle; found by linear interpolation, not proved
};

/// The curvature of an extracted surface by the derivatives of the field, not by its triangles.
///
/// In a tetrahedron the surface is smooth, and its curvature at a point is `level_curvature`.
/// Between tetrahedra the field is continuous and its derivative is not: the surface has an edge.
/// So at a vertex that several tetrahedra share the curvature tensor is the mean of theirs, each by
/// the area of its triangles there, taken across the mean normal: the curvature of the smooth
/// pieces, without what the edges between them bend.
/// Umbilics are looked for in each triangle on its own tetrahedron's tensors.
/// @param surface  with `tet`, indices into the mesh
/// The result does not depend on the number of threads.
SurfaceCurvature surface_curvature(const SurfaceMesh& surface, const TetMesh& mesh);

/// The curvature of the level of the smooth field that the mesh samples, at each vertex of the
/// surface: by derivatives recovered from the tensors around (`recovered_derivatives.hpp`). The
/// same from all tetrahedra that meet at a vertex. Its error is of first order in the size of the
/// tetrahedra; that of `surface_curvature`, which knows no second derivatives, does not fall.
/// @param surface  with `tet`, indices into the mesh
std::vector<std::optional<LevelCurvature<double>>> recovered_curvature(const SurfaceMesh& surface,
                                                                       const TetMesh& mesh);

/// Each vertex' curvature at all corners there, three a triangle.
std::vector<std::optional<LevelCurvature<double>>> at_corners(
    const SurfaceMesh& surface, const std::vector<std::optional<LevelCurvature<double>>>& vertices);

/// The umbilics in triangles whose corners have these curvatures, three a triangle.
std::vector<Umbilic> umbilics_of(const SurfaceMesh& surface,
                                 const std::vector<std::optional<LevelCurvature<double>>>& corners);

/// The curvature of the triangles as such: at each vertex, of the polynomial of degree `degree` in
/// two variables that fits the vertices around best (F. Cazals and M. Pouget, Estimating
/// differential quantities using polynomial fitting of osculating jets, 2005: on a smooth surface
/// the error is of order degree - 1 in their distance). Nothing where there are too few.
/// @param surface  with `normal`
std::vector<std::optional<LevelCurvature<double>>> jet_curvature(const SurfaceMesh& surface,
                                                                 std::size_t degree = 3);

/// Throws UsageError if the program was built without jets.
void require_jets();

}  // namespace tensortopo
