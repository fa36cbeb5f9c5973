// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tensortopo/families/random_source.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What a tetrahedron can lack of being general, alone or together with a level.
enum class Speciality {
  zero_deviator_vertex,
  two_zero_vertices,
  zero_deviator_on_edge,
  zero_deviator_inside,
  cylinder,                   ///< rank 3, constant along a direction
  cone,                       ///< rank 3, zero at a point outside
  plane_strain,               ///< all tensors have an eigenvector in common
  neutral_characteristic,     ///< the characteristic tensor has determinant 0
  degenerate_characteristic,  ///< the characteristic tensor has mode -1
  vertex_on_level,
  edge_tangent,  ///< the level touches an edge from inside
  level_constant_on_edge,
  level_constant_on_face,
  level_constant_in_cell,
  critical_value_on_face,  ///< the level is the value of a saddle in a face
  critical_value_in_cell,  ///< the level is the value of the saddle inside
  antiplane_shear,         ///< neutral everywhere
  rank_two,                ///< all deviators are combinations of two
  rank_one,                ///< all deviators are multiples of one
  rank_zero,               ///< no deviator anywhere
};

const std::vector<Speciality>& all_specialities();
std::string_view name_of(Speciality speciality);

/// The level at which it is special; nothing if it is so at all of them.
std::optional<ModeValue> special_level(Speciality speciality);

/// A tetrahedron with it: small integers, turned by a random integer quaternion, so that the
/// speciality is exact in doubles.
TetMesh special_tet(Speciality speciality, RandomSource& random);

}  // namespace tensortopo
