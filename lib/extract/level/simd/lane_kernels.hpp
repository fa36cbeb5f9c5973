// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "extract/level/lanes/has_lanes.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/simd/graph_arc.hpp"

namespace tensortopo {

/// `prove_simplex(tensors[i], level)` of several triangles or tetrahedra, bit for bit. Where
/// there are lanes, those between whose vertices the level passes are tried four at a time.
///
/// @param proofs  as many as tensors
template <std::size_t Vertices>
void prove_simplices(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                     const Level<double>& level, std::span<SimplexProof<double, Vertices>> proofs);

/// `is_proved_empty(tensors[i], level)` of several edges, triangles or tetrahedra.
///
/// @param empty  as many as tensors
template <std::size_t Vertices>
void prove_empty(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                 const Level<double>& level, std::span<char> empty);

/// The crossing of each of several edges whose ends are on different sides of the level, if it is
/// proved to be the only one without a cut: the weight of the second end, bit for bit that of
/// `edge_crossings`.
///
/// @param ends    in the order of the edge's vertices
/// @param rising  of each, whether the mode is larger at the second end
/// @param weights as many as edges; -1 where more is needed to tell, everywhere without lanes
void single_crossings(std::span<const std::array<Deviator<double>, 2>> ends,
                      std::span<const char> rising, const Level<double>& level,
                      std::span<double> weights);

/// Which of several arcs are sampled well enough by their ends, their middle being close to both:
/// `sample_arc` gives them no sample.
///
/// @param straight  as many as arcs; 0 where more is needed to tell, everywhere without lanes
void straight_arcs(std::span<const GraphArc> arcs, const Level<double>& level,
                   const LeastCosines& least, std::span<char> straight);

}  // namespace tensortopo
