// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {

/// What extraction proved of a level in each tetrahedron, in words that do not depend on where it
/// lies: the sides of vertices, the crossings of edges, the arcs and closed curves of faces, the
/// sheets with their boundary loops. Nothing for tetrahedra that it left out or that have
/// isotropic vertices.
std::vector<std::optional<std::string>> cell_signatures(const TetMesh& mesh, const ModeValue& mu,
                                                        const Extraction& extraction);

/// The same of degenerate curves: the faces that hold the ends of each arc in a tetrahedron.
/// Nothing for tetrahedra that were left out, or settled in special position.
std::vector<std::optional<std::string>> curve_signatures(const TetMesh& mesh,
                                                         const CurveExtraction& extraction);

/// The extraction that `cell_signatures` needs.
Extraction extract_with_topology(const TetMesh& mesh, const ModeValue& mu);

/// The edge of the mesh, and the number on it, of a crossing: "" for other vertices.
std::vector<std::string> names_of_crossings(const Extraction& extraction);

}  // namespace tensortopo::test
