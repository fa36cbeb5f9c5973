// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "extract/curves/special/special_cell_parts.hpp"

namespace tensortopo {

/// A face with independent tensors.
SpecialCell curve_in_full_face(const std::array<ScaledTensor, 3>& tensors, bool linear,
                               std::span<const SpecialPoint> boundary, double largest_turn,
                               std::span<const ExactDirection> crossings);

/// A tetrahedron with independent tensors.
SpecialCell curve_in_full_tet(const std::array<ScaledTensor, 4>& tensors, bool linear,
                              std::span<const SpecialPoint> boundary, double largest_turn,
                              std::span<const SpecialCell* const> faces);

}  // namespace tensortopo
