// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "claims/compare_curves.hpp"
#include "surface/compare_surface.hpp"

namespace certificate {

/// An upper bound of how much the mode, or other invariant, at the vertices of the triangles
/// differs from the level's value: at the doubles that are their coordinates, in the linear field
/// of each tetrahedron with a triangle at the vertex, left out or not. In doubles with an error
/// bound. Where these show nothing, as next to where there is no mode, it is 2 for modes, else
/// infinite; vertices at or between vertices without a mode are not asked.
double residual_bound(const LevelCase& c, const PlacedSurface& placed);

/// The same of the vertices of lines, in the field of each tetrahedron with a line at the vertex
/// that is not left out; the level's value is 1 or -1.
double residual_bound(const CurveCase& c);

}  // namespace certificate
