// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tensortopo/extract/face_curves.hpp"
#include "tensortopo/extract/leaf_mesh.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"

namespace tensortopo {

/// A tetrahedron and the mode curves on its faces.
template <class Scalar>
struct TetWithCurves {
  LevelSimplex<Scalar, 4> simplex;                         ///< positively oriented
  std::array<std::array<std::uint8_t, 3>, 4> face_vertices;  ///< of face f, by global id
  std::array<bool, 4> outward;  ///< those run counter-clockwise seen from outside
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
struct RimPiece {
  int face, arc;
  bool forward;
};

/// One connected sheet of the level in a tetrahedron: what is proved about it.
struct SheetTopology {
  std::vector<int> loops;        ///< its boundary loops
  int euler_characteristic = 1;  ///< 2 - 2 genus - number of loops
  int component = -1;            ///< in the leaf mesh, if there is one
};

/// The sheets of the level in one tetrahedron, decided by proof: either the whole tetrahedron is
/// monotone and has one boundary loop, which then bounds a disc (every sheet of a linear field
/// reaches a face), or, next to modes -1 and 1, that no critical value is near, or the refinement
/// says.
template <class Scalar>
struct TetPlan {
  std::vector<std::vector<RimPiece>> loops;  ///< directed with the sheet on the left
  std::vector<SheetTopology> sheets;
  /// If it is proved that all sheets are tubes: the arc of the degenerate curve in each, from its
  /// first loop to its second.
  std::vector<DegenerateArc> tubes;
  struct Leaves {
    Refinement<Scalar, 4> refinement;
    LeafMesh mesh;
  };
  std::unique_ptr<Leaves> leaves;  ///< while they are needed, see `add_leaves`
  bool refined = false;            ///< the sheets were found by a refinement
  /// If the level is a graph in the whole tetrahedron: along which lines, see `SimplexProof`.
  std::optional<std::array<Scalar, 4>> direction;
};

/// Joins the arcs of the faces into loops and decides what sheets they bound.
/// @param isotopic if there is one: another level of the same sign from which no critical value
///                 separates this one, so that the proof may be made there
/// @param effort   great only where the usual has failed: what that has tried is not tried again
/// @return nothing if the proof does not close within the budget, or contradicts the faces
template <class Scalar>
std::optional<TetPlan<Scalar>> plan_tet(const TetWithCurves<Scalar>& tet,
                                        const Level<Scalar>& level,
                                        const Level<Scalar>* isotopic = nullptr,
                                        Effort effort = Effort::usual);

/// The refinement of a tetrahedron that a plan could do without.
/// @return false as for `plan_tet`
template <class Scalar>
bool add_leaves(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                TetPlan<Scalar>& plan, Effort effort = Effort::usual);

/// A sample that a tetrahedron wants on a face's arc, so that both of the face's tetrahedra
/// have it.
template <class Scalar>
struct RimRequest {
  int face = 0, arc = 0;
  Scalar place{};
  bool on_boundary = false;  ///< of the complex domain of the tetrahedron that asks
};

/// Where the leaf mesh of the plan meets the face arcs.
/// One for each node of the leaf mesh; `arc` is -1 for nodes off the faces or on an edge.
template <class Scalar>
std::vector<RimRequest<Scalar>> leaf_requests(const TetWithCurves<Scalar>& tet,
                                              const Level<Scalar>& level,
                                              const TetPlan<Scalar>& plan);

/// A vertex on the boundary of the tetrahedron, as the sheets use it.
struct RimVertex {
  std::int32_t id = -1;  ///< in the output
  std::uint8_t faces = 0;
  Vector3<double> position;
  Vector3<double> medium;    ///< unit medium eigenvector, sign arbitrary
  Vector3<double> dominant;  ///< unit dominant eigenvector, sign arbitrary
};

/// A vertex inside the tetrahedron.
template <class Scalar>
struct InnerVertex {
  std::array<Scalar, 4> weights{};
  Deviator<Scalar> tensor{};
};

/// Triangles of one tetrahedron's sheets. A corner c >= 0 is the output's vertex c, c < 0 the
/// inner vertex -1 - c.
template <class Scalar>
struct TetTriangles {
  std::vector<InnerVertex<Scalar>> inner;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// For each node of the leaf mesh on an edge of the tetrahedron, the crossing that it is.
template <class Scalar>
std::map<std::uint32_t, CrossingKey> crossings_of_leaves(const TetWithCurves<Scalar>& tet,
                                                         const TetPlan<Scalar>& plan);

/// The point of the level on the edge of the refinement that a node of the leaf mesh stands for.
template <class Scalar>
InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>& refinement, const LeafMesh::Node& node,
                               const Level<Scalar>& level);

/// The vertices along the arcs of a tetrahedron's faces, in the final sampling.
struct ArcVertices {
  std::vector<RimVertex> vertices;  ///< ends included unless the arc is closed
  std::vector<double> places;       ///< one for each vertex
};
using FaceArcVertices = std::array<std::vector<ArcVertices>, 4>;

/// The vertices of a boundary loop, in its direction.
std::vector<RimVertex> loop_vertices(std::span<const RimPiece> loop,
                                     const FaceArcVertices& vertices);

/// True if a sheet is a disc that needs no inner samples: the eigenvectors turn less along its rim
/// than from one sample to the next or so (the dominant one by twice that).
bool is_small_disc(const SheetTopology& sheet, std::span<const RimVertex> rim,
                   const Sampling& sampling);

/// Triangles within a rim, without a vertex inside (`cut_polygon`). False if it cannot be cut
/// without a diagonal in a face.
template <class Scalar>
bool mesh_within_rim(std::span<const RimVertex> rim, TetTriangles<Scalar>& out);

/// Triangles from the rim of a disc to one point of it inside, taken from the plan's leaf mesh:
/// always right as a complex, so the last resort where samples fell together.
/// @return false if the sheet is no disc, or the leaf mesh has no inner node on it
template <class Scalar>
bool mesh_as_fan(const TetPlan<Scalar>& plan, const SheetTopology& sheet,
                 const FaceArcVertices& vertices, const Level<Scalar>& level,
                 TetTriangles<Scalar>& out);

/// Triangles between the rims of a sheet alone, joined by bridges and cut, for sheets that no other
/// way can spread out: two that nearly touch along a line, tubes too thin for the leaves of a
/// proof. No vertex lies inside, so the triangles follow the level no better than chords of its
/// rims.
/// @return false if the sheet has handles, or if no bridges or no cut are found: so if all its rims
///         are on one face
template <class Scalar>
bool mesh_from_rims(const TetPlan<Scalar>& plan, const SheetTopology& sheet,
                    const FaceArcVertices& vertices, TetTriangles<Scalar>& out);

/// Triangles for a sheet straight from the leaf mesh; its rim samples must be on the arcs.
template <class Scalar>
bool mesh_from_leaves(const TetPlan<Scalar>& plan, const SheetTopology& sheet,
                      std::span<const RimRequest<Scalar>> requests,
                      const TetWithCurves<Scalar>& tet, const FaceArcVertices& vertices,
                      const Level<Scalar>& level, TetTriangles<Scalar>& out);

}  // namespace tensortopo
