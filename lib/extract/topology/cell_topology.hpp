// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "extract/run/budget.hpp"
#include "extract/subdivision/refinement.hpp"
#include "extract/topology/boundary/cell_boundary.hpp"
#include "extract/topology/subdivision_mesh.hpp"
#include "tensortopo/field/degenerate_arcs.hpp"

namespace tensortopo {

/// The sheets of the level in one tetrahedron, decided by proof: either the whole tetrahedron is
/// monotone, and its boundary loops say which sheets are discs and which have holes (see
/// `graph_sheets`), or, next to modes -1 and 1, that no critical value is near, or the refinement
/// says.
template <class Scalar>
struct CellTopology {
  BoundaryLoops loops;  ///< directed with the sheet on the left
  Sheets sheets;
  /// If it is proved that all sheets are tubes: the arc of the degenerate curve in each, from its
  /// first loop to its second.
  std::vector<DegenerateArc> tubes;
  struct Subdivision {
    Refinement<Scalar, 4> refinement;
    SubdivisionMesh mesh;
  };
  std::unique_ptr<Subdivision> subdivision;  ///< while they are needed, see `add_subdivision`
  bool refined = false;                      ///< the sheets were found by a refinement
  /// If the level is a graph in the whole tetrahedron: along which lines, see `SimplexProof`.
  std::optional<std::array<Scalar, 4>> direction;
};

/// Joins the arcs of the faces into loops and decides what sheets they bound.
/// @param isotopic if there is one: another level of the same sign from which no critical value
///                 separates this one, so that the proof may be made there
/// @param budget   large only where the regular one has failed: what that has tried is not tried
///                 again
/// @return nothing if the proof does not close within the budget, or contradicts the faces
template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const Level<Scalar>* isotopic = nullptr,
                                               Budget budget = Budget::regular);

/// The refinement of a tetrahedron that a proved topology could do without.
/// @return false as for `prove_cell`
template <class Scalar>
bool add_subdivision(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                     CellTopology<Scalar>& proved, Budget budget = Budget::regular);

/// Cuts some cells of the subdivision.
/// @pre there is one
/// @return false if it cannot be proved again; then there is none
template <class Scalar>
bool refine_subdivision(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                        std::span<const std::uint32_t> cells, CellTopology<Scalar>& proved);

/// `prove_cell` at this very level: from one monotone tetrahedron or from a refinement.
template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell_by_subdivision(const TetWithCurves<Scalar>& tet,
                                                              const Level<Scalar>& level,
                                                              Budget budget);

/// `prove_cell`, of a tetrahedron whose proof as a whole has been made (or not: null).
template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell_from(const SimplexProof<Scalar, 4>* known,
                                                    const TetWithCurves<Scalar>& tet,
                                                    const Level<Scalar>& level,
                                                    const Level<Scalar>* isotopic = nullptr,
                                                    Budget budget = Budget::regular);

/// A vertex inside the tetrahedron.
template <class Scalar>
struct InnerVertex {
  std::array<Scalar, 4> weights{};
  Deviator<Scalar> tensor{};
};

/// For each node of the subdivision mesh on an edge of the tetrahedron, the crossing that it is.
/// @pre there is a subdivision
template <class Scalar>
std::map<std::uint32_t, CrossingKey> crossings_of_subdivision(const TetWithCurves<Scalar>& tet,
                                                              const CellTopology<Scalar>& proved);

/// The point of the level on the edge of the refinement that a node of the subdivision mesh stands
/// for.
template <class Scalar>
InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>& refinement,
                               const SubdivisionMesh::Node& node, const Level<Scalar>& level);

/// Where the subdivision mesh of the proved topology meets the face arcs.
/// @pre there is a subdivision
/// One for each node of the subdivision mesh; `arc` is -1 for nodes off the faces or on an edge.
template <class Scalar>
std::vector<SampleRequest<Scalar>> subdivision_requests(const TetWithCurves<Scalar>& tet,
                                                        const Level<Scalar>& level,
                                                        const CellTopology<Scalar>& proved);

}  // namespace tensortopo
