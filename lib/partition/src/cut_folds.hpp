// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Sheets that a stretch of larger modes around an edge between two isotropic vertices has at its
/// ends are joined along the edge. In a part they are only if the part has all of the stretch.
/// @param in_part  of each of the piece's tetrahedra, which have all with two isotropic vertices
/// @return pairs of triangles that share a side there, and do not in the part
std::set<std::array<std::size_t, 2>> cut_folds(const PieceSurface& piece,
                                               const std::vector<char>& in_part);

}  // namespace tensortopo
