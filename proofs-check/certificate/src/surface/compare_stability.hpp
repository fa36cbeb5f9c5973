// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "claims/compare_curves.hpp"
#include "surface/compare_surface.hpp"

namespace certificate {

using RadiiByArray = std::map<std::string, Radii>;

/// The claims that components are in all fields within a radius, one for each. A claim is certified if
/// the tetrahedra that hold the component are derived to be free of critical points for all members,
/// and none of them has a face in common with one that is left out; refuted if there is no such
/// component, if one is left out, or if a vertex has members on both sides of the level.
///
/// @param placed  null if the triangles or other things are not as claimed: then nothing is decided
/// @param radii  of each array that the claims may be about
void compare_stability(const LevelCase& c, const RadiiByArray& radii, const PlacedSurface* placed,
                       Ledger& ledger);

/// The same of degenerate curves: the tetrahedra that hold a component are derived to be transverse for
/// all members; refuted also if some member is degenerate or isotropic at a vertex.
/// @param is_sound  nothing but what is left out is open, and nothing refuted; else nothing is decided
void compare_stability(const CurveCase& c, const RadiiByArray& radii, bool is_sound,
                       const Progress& progress, Ledger& ledger);

}  // namespace certificate
