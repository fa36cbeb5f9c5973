// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/compare_surface.hpp"

namespace certificate {

/// Where the triangles' vertices lie, whatever is said of distances: a crossing's in its interval
/// of the edge, those of arcs and closed curves in their face, all in the tetrahedron of each of
/// their triangles. One claim.
void compare_places(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger);

/// On which side of the triangles larger values are. Loops through crossings are compared with
/// their directions by `compare_surface`; this is about closed curves of faces, by the signs of
/// their polygons' areas, and sheets without boundary, by their volumes. One claim.
void compare_orientation(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger);

}  // namespace certificate
