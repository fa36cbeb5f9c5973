// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/analysis/baseline.hpp"
#include "baselines/triangle_soup.hpp"
#include "extract/level/level.hpp"

namespace tensortopo::baselines {

/// The surface in one tetrahedron by A-patches.
/// @param corners  of a positively oriented tetrahedron, with tensors of one common scale
void add_a_patches(const std::array<FieldPoint, 4>& corners, SurfaceMesh::Index tet,
                   const Level<double>& level, const BaselineOptions& options,
                   std::vector<SoupTriangle>& out);

}  // namespace tensortopo::baselines
