// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The arrays of the surface's file besides its geometry.
#pragma once

#include "compare_level.hpp"

namespace certificate {

/// Are the arrays of the surface those whose hashes the certificate has, and no others? Left open
/// if it has none.
void compare_hashes(const Json& surface_claims, const Triangles& surface, Ledger& ledger);

/// Are the mode or value at each vertex, and the component of each triangle, what they are? As far
/// as there are such arrays.
/// @pre the levels' ranges follow each other, in the surface
void compare_arrays(const Json& levels, const Triangles& surface, Ledger& ledger);

}  // namespace certificate
