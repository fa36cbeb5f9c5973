// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/compare_surface.hpp"

namespace certificate {

/// The claim about distances, as one. It is certified if each triangle outside the coarse
/// tetrahedra, with its corners moved by their reaches, is above the level, and moved backwards is
/// below; and if what is between covers the level: see the README.
///
/// @param placed  null if the triangles or other things are not as claimed: then nothing is decided
/// @return whether it is certified
bool compare_distance(const LevelCase& c, const PlacedSurface* placed, Ledger& ledger);

/// How many triangles are neither left out nor in coarse tetrahedra.
std::size_t count_bounded(const LevelCase& c, const PlacedSurface& placed);

}  // namespace certificate
