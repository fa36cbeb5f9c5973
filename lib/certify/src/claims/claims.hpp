// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What claims about all kinds of levels have in common.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// For each edge its intervals, or nothing if there are none.
using Brackets = std::vector<std::optional<std::vector<DyadicBracket>>>;

/// Tetrahedra, positions in the mesh, for which there is a reason become undecided, and what only
/// they hold is no longer claimed. After that no edge without intervals is left: those that have
/// one have a reason, too.
/// @param reason  of a tetrahedron; empty: there is none
void drop_cells(const TetMesh& mesh, CertifiedLevel& level, Brackets brackets,
                const std::function<std::string(TetMesh::Index)>& reason);

/// The triangles in tetrahedra that are not undecided.
std::vector<std::size_t> decided_triangles(const TetMesh& mesh, const SurfaceMesh& surface,
                                           const CertifiedLevel& level);

std::vector<ComponentClaim> components_of(const SurfaceMesh& surface);

}  // namespace tensortopo
