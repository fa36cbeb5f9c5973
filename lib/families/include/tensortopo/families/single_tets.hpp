// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/families/random_source.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// One tetrahedron, turned around if its volume is negative (the last two vertices swap).
TetMesh single_tet(const std::array<Vector3<double>, 4>& points,
                   const std::array<SymmetricTensor<double>, 4>& tensors);

/// Independent random tensors at the origin and the ends of the axes.
TetMesh random_tet(RandomSource& random);

/// A tetrahedron around the one saddle of its linear field, at which the mode is
/// mu(s) = s (9 - s^2) / (3 + s^2)^(3/2): the field
/// [[3 + s, x, y], [x, s - 3, z], [y, z, -2 s]], turned by a random rotation.
///
/// The level mu(s) is the bifurcation mode mu0 of the field (paper, bifurcation theorem). Inside
/// the tetrahedron a level a little larger is two discs, a smaller one an annulus.
/// @param s in (0, 1)
TetMesh saddle_tet(double s, RandomSource& random);

/// How many extrema and saddles the mode has on a plane (projective, if they are isolated).
struct PlanarCount {
  /// How many of each.
  int extrema = 0, saddles = 0;
};

/// All that are possible (paper, theorem 6, as corrected): (2, 1), (3, 2), (4, 3).
inline constexpr std::array<PlanarCount, 3> kPlanarCounts{{{2, 1}, {3, 2}, {4, 3}}};

/// A tetrahedron one of whose faces has `extrema` 2, 3 or 4 extrema of the mode inside, around
/// which mode curves close up without touching an edge. A known plane, slightly perturbed and
/// turned by a random rotation; the fourth vertex has a random tensor.
TetMesh planar_extrema_tet(int extrema, RandomSource& random);

/// A polynomial of degree three in the coordinates with random tensors as coefficients, on the
/// Kuhn lattice of cells^3 hexahedra of the cube [-1, 1]^3.
TetMesh smooth_cube(int cells, RandomSource& random);

/// Independent random tensors at the vertices of that lattice.
TetMesh rough_cube(int cells, RandomSource& random);

}  // namespace tensortopo
