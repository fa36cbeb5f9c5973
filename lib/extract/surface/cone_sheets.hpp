// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tensortopo/extract/level_topology.hpp"

namespace tensortopo {

/// The sheets of all tetrahedra with isotropic vertices, read off their triangles.
///
/// @param is_apex  of each vertex: the mode is undefined there, see `separate_fans`
/// @param copies  `LevelTopology::copies`; sheets are named by the originals
std::vector<LevelTopology::Cone> cone_sheets(
    const SurfaceMesh& surface, const std::vector<char>& is_apex,
    std::span<const std::array<SurfaceMesh::Index, 2>> copies);

}  // namespace tensortopo
