// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo::test {

inline constexpr std::array<Degeneracy, 2> kKinds{Degeneracy::linear, Degeneracy::planar};

inline double mode_of(Degeneracy kind) { return kind == Degeneracy::linear ? 1 : -1; }

/// Where curves may end.
enum class CurveEnds {
  even,  ///< inside, away from unresolved tetrahedra, a vertex ends an even number of lines
  free,  ///< anywhere: a curve that counts twice, as where two coincide, may turn complex
};

/// Everything that can be wrong with extracted curves, in words; "" if nothing is.
///
/// Combinatorial: full arrays; a line runs in one cell of a tetrahedron (itself, a face or an
/// edge), with inner vertices of that cell, and ends in the cell or on its boundary; along an edge
/// there is one line, not one for each tetrahedron; the lines of a component follow each other from
/// junction to junction; ends as above; lines in unresolved tetrahedra only where these have
/// surfaces besides. At 50 digits: the vertices are in their tetrahedron up to the rounding of
/// coordinates, have the mode's sign, and are as near to degenerate as coordinates in doubles can
/// be. That is: with h_k one unit in the last place of coordinate k, the field differs from a
/// degenerate tensor by at most the sum of |dT/dx_k| h_k, and sqrt(1 - mode^2) = sin(3 phi) for a
/// tensor at angle phi (which is less than pi / 2 times that over |T|) from a degenerate one.
std::string flaws(const CurveExtraction& extraction, const TetMesh& mesh, double mode,
                  CurveEnds ends = CurveEnds::even);

/// From a place to the nearest one on the curves; infinite if there are none.
double distance(const Vector3<double>& x, const CurveMesh& curves);

/// Of a component of curves: how far its vertices are from other curves, at most, and its length.
struct Away {
  double distance = 0, length = 0;
};

/// Of each component, by its number.
/// @param each  only every so many vertices of a line are looked at
std::map<std::int64_t, Away> away_from(const CurveMesh& other, const CurveMesh& curves,
                                       std::size_t each = 1);

}  // namespace tensortopo::test
