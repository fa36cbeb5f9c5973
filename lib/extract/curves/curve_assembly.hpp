// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/curves/points/curve_in_tet.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// The vertices of a simplex of the mesh; -1 fills up.
using SimplexVertices = std::array<TetMesh::Index, 4>;

/// A place where pieces of curves end and meet, found once for all cells around it.
struct CurvePlace {
  SimplexVertices vertices{-1, -1, -1, -1};  ///< of the simplex whose interior holds it, ascending
  std::array<Extended, 4> weights{};         ///< of these
  Vector3<Extended> dominant{};              ///< zero where the deviator vanishes
};

/// A piece of a curve in the interior of a simplex.
struct CurveLink {
  TetMesh::Index tet = -1;                   ///< the tetrahedron, or one around it
  SimplexVertices vertices{-1, -1, -1, -1};  ///< those that the weights of `inner` refer to
  std::array<std::size_t, 2> ends{};         ///< positions in the list of places
  std::vector<CurveSample> inner;
};

/// A link in a component, run from its end `from` to the other one.
struct CurveStep {
  std::size_t link;
  std::size_t from;
};

/// Curves, and what they were put together from.
struct AssembledCurves {
  CurveMesh curves;
  std::vector<std::size_t> places;  ///< of the first vertices; behind them are those of `inner`
  std::vector<std::size_t> inner;   ///< of each vertex behind them: the link
  std::vector<CurveStep> steps;     ///< of each line
};

/// Numbers the vertices, and puts the lines of each component in order.
AssembledCurves assemble_curves(const TetMesh& mesh, const ScaledField<double>& field,
                                Degeneracy kind, const std::vector<CurvePlace>& places,
                                const std::vector<CurveLink>& links, const ExtractOptions& options);

}  // namespace tensortopo
