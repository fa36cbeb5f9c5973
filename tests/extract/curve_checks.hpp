// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo::test {

/// Everything that can be wrong with extracted curves, in words; "" if nothing is.
///
/// Combinatorial: full arrays; lines run through one tetrahedron from face to face, with inner
/// vertices of that tetrahedron; a vertex in a face ends one line for each tetrahedron at that face
/// that is not unresolved; the lines of a component follow each other. At 50 digits: the vertices
/// are in their tetrahedron up to the rounding of coordinates, have the mode's sign, and are as
/// near to degenerate as coordinates in doubles can be. That is: with h_k one unit in the last
/// place of coordinate k, the field differs from a degenerate tensor by at most the sum of
/// |dT/dx_k| h_k, and sqrt(1 - mode^2) = sin(3 phi) for a tensor at angle phi (which is less than
/// pi / 2 times that over |T|) from a degenerate one.
std::string flaws(const CurveExtraction& extraction, const TetMesh& mesh, double mode);

}  // namespace tensortopo::test
