// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Triangles from the boundary loop of a disc to one point of it inside, taken from the proved
/// subdivision mesh: always right as a complex, so the last resort where samples fell together.
/// @return false if the sheet is no disc, or the subdivision mesh has no inner node on it
template <class Scalar>
bool mesh_as_fan(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                 const FaceArcVertices& vertices, const Level<Scalar>& level, Patch<Scalar>& out);

}  // namespace tensortopo
