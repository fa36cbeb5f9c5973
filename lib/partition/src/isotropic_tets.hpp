// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tensortopo/partition/mesh_piece.hpp"

namespace tensortopo {

/// Whether the deviator is zero.
bool is_isotropic(const SymmetricTensor<double>& tensor);

/// The ids of the owned tetrahedra that are isotropic at all four vertices, as runs.
std::vector<std::array<std::int64_t, 2>> isotropic_ids_of(const MeshPiece& piece);

}  // namespace tensortopo
