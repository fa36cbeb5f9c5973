// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "restart_file.hpp"

namespace tensortopo::scenarios {

/// (rational + root3 * sqrt(3)) / 4, exactly.
struct QuarterOfRoot3 {
  int rational = 0, root3 = 0;
};

/// Weight of an integration point in the value at a corner whose sign agrees with the point's on
/// so many of the three axes.
///
/// The trilinear function through the values at (+-1, +-1, +-1) / sqrt(3), at a corner of the cube:
/// ((1 + sqrt 3) / 2)^agreeing ((1 - sqrt 3) / 2)^(3 - agreeing).
QuarterOfRoot3 exact_weight(int agreeing);

/// Number of axes on which the signs of a corner and of an integration point agree.
int agreeing_signs(std::size_t corner, std::size_t integration_point);

/// Weights by which stresses at integration points become stresses at corners.
enum class Weights {
  exact,     ///< `exact_weight`, each rounded once or twice
  calculix,  ///< the same to 3 or 4 digits, with which CalculiX fills its .frd files
};

/// The stress at each node of the mesh: extrapolated to the corners of each hexahedron, then the
/// plain mean over the hexahedra at the node, across materials too.
///
/// Laws      with exact weights a stress that is linear in space comes back at the nodes, to
///           rounding (the map from the cube to a hexahedron is trilinear, and so is the stress on
///           it).
/// Requires  one stress per hexahedron (std::invalid_argument).
std::vector<SymmetricTensor<double>> nodal_stress(
    const HexMesh& mesh, const std::vector<RestartFile::HexStress>& stresses, Weights weights);

}  // namespace tensortopo::scenarios
