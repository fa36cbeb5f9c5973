// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Triangles for a sheet straight from the subdivision mesh; its boundary loop samples must be on
/// the arcs.
template <class Scalar>
bool mesh_from_subdivision(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                           std::span<const SampleRequest<Scalar>> requests,
                           const TetWithCurves<Scalar>& tet, const FaceArcVertices& vertices,
                           const Level<Scalar>& level, Patch<Scalar>& out);

}  // namespace tensortopo
