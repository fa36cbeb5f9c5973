// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/extract/level_topology.hpp"

namespace tensortopo {

/// The sheets of all tetrahedra with vertices without deviator, read off their triangles.
///
/// @param is_apex  of each vertex: the mode is undefined there, see `separate_fans`
std::vector<LevelTopology::Cone> cone_sheets(const SurfaceMesh& surface,
                                             const std::vector<char>& is_apex);

}  // namespace tensortopo
