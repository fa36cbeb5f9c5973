// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fans of triangles around vertices of a piece's surface.
#pragma once

#include <array>
#include <cstddef>
#include <set>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Triangles at a copy of a crossing's vertex get the vertex that it is a copy of.
void join_copies(PieceSurface& piece);

/// Each fan of triangles at a crossing or an isotropic vertex gets a vertex of its own: the first
/// one keeps it.
/// @param apart  pairs of triangles, ascending, that share a side and are not of one fan there
void separate_copies(PieceSurface& piece, const std::set<std::array<std::size_t, 2>>& apart);

}  // namespace tensortopo
