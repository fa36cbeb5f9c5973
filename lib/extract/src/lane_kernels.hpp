// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tensortopo/extract/simple_simplex.hpp"

namespace tensortopo {

/// The instructions that a kernel may use. What it returns does not depend on them.
enum class Instructions { any, avx2 };

/// The best that this processor has, and this build.
Instructions best_instructions();

/// `prove_simplex(tensors[i], level)` of several triangles or tetrahedra, bit for bit: those between
/// whose vertices the level passes four at a time, as far as the first direction proves them.
///
/// @param proofs  as many as tensors
template <std::size_t Vertices>
void prove_simplices(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                     const Level<double>& level, std::span<SimplexProof<double, Vertices>> proofs,
                     Instructions instructions = best_instructions());

/// The crossing of each of several edges whose ends are on different sides of the level, if it is
/// proved to be the only one without a cut: the weight of the second end, bit for bit that of
/// `edge_crossings`.
///
/// @param ends    in the order of the edge's vertices
/// @param rising  of each, whether the mode is larger at the second end
/// @param weights as many as edges; -1 where more is needed to tell
void single_crossings(std::span<const std::array<Deviator<double>, 2>> ends,
                      std::span<const char> rising, const Level<double>& level,
                      std::span<double> weights, Instructions instructions = best_instructions());

}  // namespace tensortopo
