// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Triangles within a boundary loop, without a vertex inside (`cut_polygon`). False if it cannot be cut
/// without a diagonal in a face.
template <class Scalar>
bool fill_loop(std::span<const BoundaryVertex> boundary, Patch<Scalar>& out);

}  // namespace tensortopo
