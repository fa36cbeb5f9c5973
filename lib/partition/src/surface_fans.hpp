// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Fans of triangles around vertices of a piece's surface.
#pragma once

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// Triangles at a copy of a crossing's vertex get the vertex that it is a copy of.
void join_copies(PieceSurface& piece);

/// Each fan of triangles at a crossing gets a vertex of its own: the first one keeps it.
/// @throws std::invalid_argument if an isotropic vertex has several fans
void separate_copies(PieceSurface& piece);

}  // namespace tensortopo
