// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "extract/topology/boundary/face_curves.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// A tetrahedron and the mode curves on its faces.
template <class Scalar>
struct TetWithCurves {
  LevelSimplex<Scalar, 4> simplex;                           ///< positively oriented
  std::array<std::array<std::uint8_t, 3>, 4> face_vertices;  ///< of face f, by global id
  std::array<bool, 4> outward;       ///< those run counter-clockwise seen from outside
  std::array<bool, 6> edge_forward;  ///< edge ij, i < j: global ids ascend from i to j
  std::array<Vector3<double>, 4> points;
  std::array<std::span<const FaceArc<Scalar>>, 4> arcs;

  /// The tensors at the corners of a face, in the order of their global ids.
  std::array<Deviator<Scalar>, 3> face_tensors(std::size_t face) const {
    const auto& v = face_vertices[face];
    return {simplex.tensors[v[0]], simplex.tensors[v[1]], simplex.tensors[v[2]]};
  }
};

/// A crossing of an edge of a tetrahedron: which edge, and which of its crossings.
using CrossingKey = std::pair<int, int>;

/// The crossing at which an arc of a face of the tetrahedron ends.
template <class Scalar>
CrossingKey crossing_of(const TetWithCurves<Scalar>& tet, int face, const ArcEnd& end);

/// A part of a boundary loop: one arc of one face, forwards or backwards.
struct BoundaryArc {
  int face, arc;
  bool forward;
};

/// Boundary loops; nearly all tetrahedra have one, of three or four arcs.
using BoundaryLoop = boost::container::small_vector<BoundaryArc, 4>;
using BoundaryLoops = boost::container::small_vector<BoundaryLoop, 1>;

/// Joins the arcs of the faces to closed loops, directed with the sheet on the left: at each
/// crossing of an edge one arc arrives and one leaves.
/// @return false if they do not
template <class Scalar>
bool join_arcs(const TetWithCurves<Scalar>& tet, BoundaryLoops& loops);

/// Which of the boundary loops; mostly one or two.
using LoopNumbers = boost::container::small_vector<int, 2>;

/// One connected sheet of the level in a tetrahedron: what is proved about it.
struct SheetTopology {
  LoopNumbers loops;             ///< its boundary loops
  int euler_characteristic = 1;  ///< 2 - 2 genus - number of loops
  int component = -1;            ///< in the subdivision mesh, if there is one
};
using Sheets = boost::container::small_vector<SheetTopology, 1>;

/// A sample that a tetrahedron wants on a face's arc, so that both of the face's tetrahedra
/// have it.
template <class Scalar>
struct SampleRequest {
  int face = 0, arc = 0;
  Scalar place{};
  bool on_boundary = false;  ///< of the complex domain of the tetrahedron that asks
};

}  // namespace tensortopo
