// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "distances/moved_vertices.hpp"

namespace certificate {

/// Does what lies between the moved triangles of a sheet cover the level's sheet, if that meets no
/// edge? It does if on one of the faces the band between its moved polygons has a degree other than
/// zero over one of its closed curves. The polygons ahead are above and the ones behind are
/// below the level; so that degree is the number of times that those ahead wind around a
/// point just below the curve, less that of those behind around a point just above.
bool is_covered(const LevelCase& c, const MovedVertices& moved, std::size_t tet,
                const std::vector<ClosedLoop>& loops);

}  // namespace certificate
