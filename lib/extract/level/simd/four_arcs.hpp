// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/level/simd/four_lanes.hpp"
#include "extract/level/simd/graph_arc.hpp"

namespace tensortopo {

/// A bit for each of one to four arcs: see `straight_arcs`.
unsigned straight_four(std::span<const GraphArc> arcs, const LevelNumbers& level,
                       const LeastCosines& least);

}  // namespace tensortopo
