// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Other ways to a mode surface, to compare with. None claims anything about topology.
enum class Baseline {
  /// Marching tetrahedra on the modes of the mesh's vertices, taken as linear in between: what
  /// contouring a scalar field does.
  marching,
  /// Patches of the degree-six form that each line from an apex (or between two opposite edges)
  /// meets at most once, found by signs of Bernstein coefficients, tetrahedra without one halved:
  /// Luk and Mann, "Tessellating algebraic curves and surfaces using A-patches", 2009, as Palacios
  /// et al., "Feature surfaces in symmetric tensor fields based on eigenvalue manifold", 2016, use
  /// them. Patches of neighbours are sampled on their own, so the surface has cracks where the
  /// apices differ.
  a_patches,
  /// The neutral surface alone, parameterized by the medium eigenvector in each tetrahedron by
  /// itself: after Roy, Kumar, Guo, Zhang and Zhang, "Robust and fast extraction of 3D symmetric
  /// tensor field topology", 2019. Neighbours sample a shared face on their own: cracks.
  hybrid,
};

struct BaselineOptions {
  int halvings = 12;  ///< of a tetrahedron, at most; what is left then is marched
  int samples = 2;    ///< of a patch, along each side
  /// Of method `hybrid`: largest distance of its triangles from the surface, in units of the
  /// longest edge of the tetrahedron.
  double flatness = 1.0 / 32;
};

/// The surface {mode = mu}, |mu| < 1, with `points`, `triangles` (counter-clockwise seen from the
/// larger mode), `tet`, `component` and `mode` filled. Vertices at one point are one.
/// An isotropic vertex counts as below.
/// Throws std::invalid_argument for |mu| >= 1, and for `hybrid` unless mu is 0.
SurfaceMesh baseline_surface(Baseline method, const TetMesh& mesh, const ModeValue& mu,
                             const BaselineOptions& options = {});

}  // namespace tensortopo
