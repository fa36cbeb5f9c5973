// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The arrays of the file of the surface, or of the curves, besides its geometry.
#pragma once

#include "claims/compare_level.hpp"

namespace certificate {

/// Are the arrays those whose hashes the certificate has, and no others? Left open if it has none.
void compare_hashes(const Json& file_claims, const std::vector<Array>& arrays, Ledger& ledger);

/// Are the mode or value at each vertex, and the component of each triangle, what they are? As far
/// as there are such arrays.
/// @pre the levels' ranges follow each other, in the surface
void compare_arrays(const Json& levels, const Triangles& surface, Ledger& ledger);
/// The same of curves' modes and components.
void compare_arrays(const Json& levels, const Polylines& curves, Ledger& ledger);

}  // namespace certificate
