// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/fields/random_fields.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// Families of fields from which the cases are drawn.
enum class Family {
  general,              ///< independent normal tensors
  small_integers,       ///< entries from -2 to 2: ties, equal tensors, low ranks
  sparse_integers,      ///< entries from -9 to 9, half of them zero
  powers_of_two,        ///< each tensor scaled by a power of two between 2^-27 and 2^27
  scales,               ///< each tensor scaled by a factor between 1e-8 and 1e8
  large_trace,          ///< with a multiple of the identity up to 2^34, without rounding
  rotated,              ///< small integers, rotated with rounding
  nearly_rank_one,      ///< multiples of one tensor, and a rest of 1e-6
  nearly_rank_two,      ///< combinations of two tensors, and a rest of 1e-6
  nearly_special,       ///< within 2^-20 or 2^-36 of a degenerate configuration
  slivers,              ///< normal tensors in a flat tetrahedron
  needles,              ///< and in a long one
  cut,                  ///< one linear field in many tetrahedra
  cut_integers,         ///< the same of small integers
  meshes,               ///< cubes of six tetrahedra each, normal tensors
  special_meshes,       ///< cubes with what is special about tensors: see `MeshKind`
  turned_slivers,       ///< flat tetrahedra in general position, far from the origin or not
  nearly_uniform,       ///< one tensor and a rest between 2^-20 and 2^-50; the mode is that tensor's
};

const std::vector<Family>& all_families();
std::string name_of(Family family);

/// A field, a mode of it, and the level of another invariant: "magnitude 3/2".
struct FieldCase {
  TetMesh mesh;
  std::string mode, invariant;
};

/// The case of a number in its family, the same on every machine.
FieldCase field_case(Family family, int number);

/// Four tensors of one linear field with 16 binary places, so that sums and products with small
/// dyadic numbers are exact.
TetTensors short_tensors(Random& random);

/// The same linear field in more tetrahedra: a new vertex inside a random edge, face or
/// tetrahedron, by `steps` times, every tetrahedron around being divided. Positions and tensors are
/// means with weights of three binary places; they are exact if the entries have few bits.
/// @return the index of the new vertices' simplices: those of two vertices are edges
struct Cut {
  std::vector<TetMesh::Index> simplex;  ///< ascending vertices between which it lies
};
std::vector<Cut> cut(TetMesh& mesh, int steps, Random& random);

}  // namespace tensortopo::test
