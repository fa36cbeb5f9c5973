// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// One thing that makes a mesh unfit as a domain of a piecewise linear field.
struct MeshDefect {
  /// What is wrong.
  enum class Kind {
    wrong_length,        ///< tensors or cell ids are not one for each point or tetrahedron
    non_finite_point,    ///< a coordinate is infinite or not a number
    non_finite_tensor,   ///< a component is infinite or not a number
    out_of_range,        ///< a coordinate beyond 1e100, or vertices of one cell within 1e-100
    index_out_of_range,  ///< a tetrahedron names a vertex that does not exist
    repeated_vertex,     ///< a tetrahedron names a vertex twice
    degenerate_cell,     ///< four vertices in one plane, exactly
    inverted_cell,       ///< negative volume; `repair_orientation` cures it
    duplicated_cell,     ///< the same four vertices as another tetrahedron
    crowded_face,        ///< a face of three or more tetrahedra
    overlapping_cells,   ///< two tetrahedra on the same side of the face that they share
  };

  Kind kind;           ///< what is wrong
  std::int64_t where;  ///< vertex number, or the tetrahedron's id in the input
  std::string text;    ///< what is wrong and where, without a full stop
};

/// A face of one tetrahedron only: on the boundary of the domain, or where the mesh is torn.
struct OuterFace {
  std::array<TetMesh::Index, 3> vertices;  ///< counter-clockwise as seen from outside
  TetMesh::Index tet;                      ///< the one that it belongs to
};

/// The defects of a mesh: empty if it is fit.
///
/// @param outer gets the outer faces, ascending by their vertices in ascending order
///
/// Laws      (1) no defect means: all numbers finite, products of three lengths neither too large
///           nor too small for doubles (coordinates up to 1e100, edges from 1e-100), every
///           tetrahedron has positive volume
///           (decided exactly), and every face has at most two tetrahedra, on its two sides;
///           (2) the order is by kind of check, then by cell, the same on every run.
/// Policy    Inverted tetrahedra are defects here; the reader turns them around first. Points that
///           no tetrahedron uses are allowed. Overlap of tetrahedra that share no face is not
///           looked for, nor hanging nodes: see `unmatched_faces`.
/// Cost      about 0.2 us a tetrahedron; at most 1000 defects are listed.
std::vector<MeshDefect> validate(const TetMesh& mesh, std::vector<OuterFace>* outer = nullptr);

/// Gives every tetrahedron positive volume by swapping its last two vertices where needed.
///
/// Leaves flat tetrahedra, and those with indices out of range, for `validate` to name.
/// Returns the number of tetrahedra turned around.
std::size_t repair_orientation(TetMesh& mesh);

/// Number of points that no tetrahedron uses (indices must be in range).
std::size_t count_unreferenced_points(const TetMesh& mesh);

}  // namespace tensortopo
