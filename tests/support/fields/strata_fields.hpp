// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "random_fields.hpp"

namespace tensortopo::test {

/// What the tensors at the vertices of a tetrahedron can lack of being general, alone or together
/// with a level.
enum class Stratum {
  general,
  cylinder,           ///< rank 3, constant along a direction
  cone_apex_outside,  ///< rank 3, zero at a point outside
  cone_apex_inside,   ///< rank 3, zero at a point inside
  zero_on_face,       ///< three vertices of rank 2, zero between them
  zero_on_edge,       ///< two vertices with opposite deviators
  rank_two,
  rank_one,
  rank_zero,
  zero_vertex,
  two_zero_vertices,
  three_zero_vertices,
  neutral_complement,   ///< the characteristic tensor has determinant zero
  uniaxial_complement,  ///< the characteristic tensor has mode -1
  plane_strain,
  antiplane_shear,
  vertex_on_level,
  tangent_edge,  ///< the level touches an edge
  face_saddle,   ///< the level is the value of a saddle in a face
  tet_saddle,    ///< the level is the value of the saddle, which is inside
  constant_edge,
  constant_face,
  constant_cell,
  symmetric_face,     ///< all tensors of a face have an eigenvector in common: a plane of symmetry
  plane_strain_face,  ///< and the same eigenvalue for it: extrema of the face fill a circle
  face_minimum,       ///< the level is the value of a minimum inside a face
  face_maximum,       ///< the level is the value of a maximum inside a face
  degenerate_edge,    ///< all tensors of an edge are degenerate, with one dominant eigenvector
};

const std::vector<Stratum>& all_strata();
std::string name_of(Stratum stratum);

/// The level at which a stratum is special; "" if it is so at all of them.
std::string special_mode(Stratum stratum);

/// Tensors of the stratum with small integer entries.
TetTensors stratum_tensors(Stratum stratum, Random& random);

/// Tensors in a stratum and others of small whole numbers times `rest`. What is in the stratum has
/// few bits: with rests of powers of two down to 2^-36 nothing is rounded.
TetTensors nearly_in_stratum(Stratum stratum, double rest, std::uint64_t seed);

}  // namespace tensortopo::test
