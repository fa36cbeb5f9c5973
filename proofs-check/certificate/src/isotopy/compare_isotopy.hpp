// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/compare_surface.hpp"

namespace certificate {

/// The claim that the triangles are isotopic to the level in each tetrahedron but those that it
/// excepts, one claim in all. THEOREMS.md states the theorem; of its hypotheses those of
/// each tetrahedron are derived here for all that hold triangles, excepted or not, and the report
/// says which are shown and why the others are not.
///
/// @param placed  null if the triangles or other things are not as claimed: then nothing is decided
/// @param is_near  whether the claim about distances is certified
void compare_isotopy(const LevelCase& c, const PlacedSurface* placed, bool is_near,
                     Ledger& ledger);

}  // namespace certificate
