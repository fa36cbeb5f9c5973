// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "topology.hpp"

namespace tensortopo::test {

/// What to check a surface against, besides its own consistency.
struct SurfaceCheckOptions {
  /// Whether vertices u and v lie together in one face of the boundary of the domain. Without it
  /// the coordinates decide: some face of the triangle's tetrahedron that no other tetrahedron
  /// shares holds both points up to rounding.
  std::function<bool(SurfaceMesh::Index u, SurfaceMesh::Index v)> on_domain_boundary;

  /// Residuals up to this (in units of the mode) are fine; a larger one must be explained by the
  /// rounding of the vertex's coordinates.
  double residual_tolerance = 1e-12;

  /// Compute modes with 50 digits; the expensive part, 30 us a vertex and tetrahedron.
  bool check_residuals = true;

  /// Whether a triangle whose normal opposes that of a corner is a violation or only counted.
  bool opposed_normals_are_violations = false;

  /// At most so many violations of each kind are spelled out.
  int spelled_out = 5;
};

/// What the mode of the exact linear field is at the coordinates of the vertices.
struct ResidualReport {
  int evaluated = 0;       ///< pairs of a vertex and a tetrahedron of a triangle at it
  double largest = 0;      ///< of |mode - m|
  int above = 0;           ///< pairs above the tolerance
  int explained = 0;       ///< of these, how many the rounding of the coordinates explains
  double worst_ratio = 0;  ///< largest |mode - m| over what rounding explains, among those above
};

struct SurfaceReport {
  std::vector<std::string> violations;        ///< empty if the surface is sound
  std::vector<ComponentTopology> components;  ///< counted from the triangles, sorted
  int boundary_edges = 0;
  int opposed_normals = 0;  ///< corners of triangles whose normals disagree
  ResidualReport residuals;

  bool sound() const { return violations.empty(); }
};

/// Violations and components in lines, for failure messages.
std::ostream& operator<<(std::ostream& out, const SurfaceReport& report);

/// Checks a surface by code that shares nothing with the library's own invariants.
///
/// Combinatorial: arrays of one length each, indices in range, no repeated index or triangle, no
/// vertex without triangle, every edge between two triangles that run along it in opposite
/// directions or in one triangle and on the boundary of the domain, vertex links paths or cycles,
/// component labels in order of first triangle and constant exactly on components.
/// Geometric: finite coordinates, no two vertices at one point, unit normals and eigenvectors,
/// triangles counter-clockwise seen from the larger mode. (Where the mode is undefined several
/// vertices may be at one point, and eigenvectors are zero.)
/// Numerical (50 digits): the mode of the linear field of each triangle's tetrahedron at its
/// corners is the mode asked for, up to the tolerance or the rounding of the coordinates, and the
/// corners lie in the tetrahedron up to rounding.
SurfaceReport check_surface(const SurfaceMesh& surface, const TetMesh& mesh,
                            const SurfaceCheckOptions& options = {});

/// Only the components: Euler characteristic and boundary loops of each, sorted.
std::vector<ComponentTopology> surface_topology(const SurfaceMesh& surface);

}  // namespace tensortopo::test
