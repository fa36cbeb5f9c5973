// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tensortopo/partition/mesh_piece.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The ids of vertices whose mode is exactly that, as `PieceSurface::on_level` has them.
std::vector<std::int64_t> vertices_on_level(const MeshPiece& piece, const ModeValue& mode);

}  // namespace tensortopo
