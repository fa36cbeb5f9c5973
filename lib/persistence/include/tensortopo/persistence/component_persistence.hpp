// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo {

/// How much each component of a mode surface matters: in radians of the signed Lode angle, the
/// smaller of how far the mode rises above the level in the component of {mode >= m} on its one
/// side, and how far it falls below in the component of {mode <= m} on the other.
///
/// In a field whose angles differ by less than half of that both components have counterparts.
/// @param surface  of the mode, as extracted; its vertices on edges of the mesh say which
///                 components it is between
/// @param numbers  in `mesh` of the vertices of the mesh that the surface was extracted from;
///                 empty if that is `mesh`
/// @return for each component; nothing where that is not known: no edge crosses it once, or on the
///         side where the mode changes less a critical point without a proof may join more to it
std::vector<std::optional<double>> component_persistence(
    const TetMesh& mesh, const PersistenceInput& input, const SurfaceMesh& surface, double mode,
    std::span<const TetMesh::Index> numbers = {});

/// How much each component of the degenerate curves of mode 1 or -1 matters: the persistence of its
/// pair in the signed Lode angle; nothing where the pair is not certain.
std::vector<std::optional<double>> curve_persistence(const ModePersistence& persistence, int mode,
                                                     std::size_t components);

/// The components marked, in order, with the vertices that they use; numbered anew.
SurfaceMesh kept_components(const SurfaceMesh& surface, const std::vector<char>& keep);
CurveMesh kept_components(const CurveMesh& curves, const std::vector<char>& keep);

}  // namespace tensortopo
