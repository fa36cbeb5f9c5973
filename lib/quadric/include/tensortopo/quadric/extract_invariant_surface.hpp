// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/quadric/invariant_level.hpp"

namespace tensortopo {

/// How the surface of an invariant is extracted.
struct InvariantOptions {
  /// In how many parts each edge of a crossed tetrahedron is cut before it is marched: how finely
  /// the surface is drawn. Its topology does not depend on it. 1 to 256.
  int pieces = 2;
  /// Called now and then, from one thread at a time, with the stage and how much of it is done.
  std::function<void(std::string_view stage, double fraction)> progress;
};

/// What the extraction did, for reports.
struct InvariantStatistics {
  std::size_t tets_crossed = 0;       ///< hold triangles
  std::size_t tets_refined = 0;       ///< the level meets a simplex in its interior only
  std::size_t vertices_on_level = 0;  ///< vertices of the mesh whose invariant is exactly that
  std::size_t signs_exact = 0;        ///< answers that took rationals
  /// Time of each stage, in seconds.
  double seconds_tets = 0, seconds_stitch = 0;
};

/// The surface of an invariant, and what is known of it.
struct InvariantExtraction {
  SurfaceMesh surface;  ///< the triangles
  /// Ascending. An anisotropy is undefined for the zero tensor, where its two nappes meet: these
  /// tetrahedra hold that tensor and the level, and are left out.
  std::vector<TetMesh::Index> zero_tensor;
  /// A crossing's vertex and another at the same place, see `SurfaceMesh`; ascending.
  std::vector<std::array<SurfaceMesh::Index, 2>> copies;
  InvariantStatistics statistics;  ///< what was done
};

/// The surface {invariant = value} of the piecewise linear field: a quadric in each tetrahedron.
///
/// Theorem (ours; proof at `level_in_cell`). In each tetrahedron {invariant <= value} is convex, or
/// two convex sets for an anisotropy, so exact answers to two questions give its topology: whether
/// a vertex is in it, and whether it meets a simplex without its corners. All crossings of an edge
/// (at most two), all arcs and closed conics of a face, all sheets of a
/// tetrahedron and closed ellipsoids inside it are there, and nothing else.
///
/// Laws      (1) a manifold, oriented: counter-clockwise seen from larger values; its boundary is
///           on the boundary of the domain or of tetrahedra in `zero_tensor` (where parts meet in a
///           vertex only, each fan of triangles has one of its own); (2) the level is value + 0:
///           points exactly on the level count as below, so no level at a critical value or
///           constant on a cell is left open; (3) tensors and value times a power of two give the
///           same surface (for an anisotropy the tensors alone); (4) the result does not depend on
///           the number of threads.
/// Around a point of the mesh on the level, vertices keep 2^-40 of a segment off it. `mode` and the
/// eigenvectors are left empty; `value` is filled.
/// @pre the mesh is valid (see `validate`); pieces in [1, 256] (throws std::invalid_argument)
InvariantExtraction extract_invariant_surface(const TetMesh& mesh, const InvariantLevel& level,
                                              const InvariantOptions& options = {});

}  // namespace tensortopo
