// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is said of the vertices of a piece's curves, to be compared with other pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

/// Of each vertex: the sum of hashes of the tetrahedra of the lines that end there.
/// @param cell_ids  of the tetrahedra in which `curves.tet` counts
std::vector<std::uint64_t> lines_around(const CurveMesh& curves,
                                        std::span<const std::int64_t> cell_ids);

/// A hash of all numbers of a vertex that pieces which have it agree on.
std::uint64_t digest_of_vertex(const PieceCurves& piece, std::size_t vertex);

/// @throws std::invalid_argument unless all are of one kind
/// @param pieces  curves (`PieceCurves`) or seams (`CurveSeam`)
template <class Piece>
void require_one_kind(std::span<const Piece> pieces);

}  // namespace tensortopo
