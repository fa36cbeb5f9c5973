// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract/topology/boundary/face_curves.hpp"

namespace tensortopo {

/// The curves of a face that needs no refinement: proved as a whole to hold nothing, or a graph
/// across a direction. The crossings of its edges then say which are joined: a line of that
/// direction that moves across the face meets the graph while it enters below the level and leaves
/// above it, and it never enters above and leaves below.
///
/// @param arcs  receives them, without samples
/// @param known  the proof, if it has been made
/// @return false if there is no such proof, or the crossings can be joined in several ways
template <class Scalar>
bool arcs_of_graph(const LevelSimplex<Scalar, 3>& triangle,
                   const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
                   const Level<Scalar>& level, std::vector<FaceArc<Scalar>>& arcs,
                   const SimplexProof<Scalar, 3>* known = nullptr);

/// `face_curves`, of a face whose proof as a whole has been made.
template <class Scalar>
std::optional<std::vector<FaceArc<Scalar>>> face_curves_by(
    const SimplexProof<Scalar, 3>* known, const LevelSimplex<Scalar, 3>& triangle,
    const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
    const Level<Scalar>& level, const Sampling& sampling, Budget budget = Budget::regular);

}  // namespace tensortopo
