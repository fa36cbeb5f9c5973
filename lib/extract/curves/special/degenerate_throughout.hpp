// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "extract/curves/special/special_cell.hpp"

namespace tensortopo {

/// Whether all tensors of a tetrahedron are multiples of one degenerate deviator, and one at a
/// vertex is of the kind sought: then the tetrahedron is degenerate throughout, or on one side of a
/// plane, and `special_cell` says so (`CurveObstacle::degenerate_throughout`). Exact.
///
/// Cost      some twenty multiplications of doubles for tensors that are not nearly parallel.
bool is_degenerate_throughout(const std::array<ScaledTensor, 4>& tensors, bool linear);

}  // namespace tensortopo
