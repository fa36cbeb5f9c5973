// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fields/merge_points.hpp"
#include "grids/raw_grid.hpp"
#include "tensortopo/mesh/torn_faces.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::detail {

/// The faces where cells meet without sharing them: `unmatched_faces`, and the triangles of each
/// quadrilateral of a split cell whose other side is cut along the other diagonal, even if its
/// corners are in no plane.
///
/// @param mesh  made of the pieces; `map` says where their points went
/// @param outer as `validate` gives them
TornFaces torn_faces(const std::vector<RawGrid>& pieces, const VertexMap& map, const TetMesh& mesh,
                     std::span<const OuterFace> outer);

}  // namespace tensortopo::detail
