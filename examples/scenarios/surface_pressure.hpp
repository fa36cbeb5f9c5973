// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenario.hpp"

namespace tensortopo::scenarios {

/// A constant pressure on the top face of a hexahedron, positive if it pushes.
struct FacePressure {
  Index hex = -1;
  double pressure = 0;  ///< MPa
};

/// The loads as constant pressures on faces, in the order of the hexahedra.
///
/// Each load's shape is averaged over a face by 20 x 20 samples, then scaled such that pressures
/// times areas add up to the load's force; pressures of several loads on one face are added.
/// Throws  std::invalid_argument if a load meets no face.
std::vector<FacePressure> surface_pressures(const Scenario& scenario);

/// A force and its moment about the origin.
struct Wrench {
  Vector3<double> force, moment;  ///< N, N mm
};

/// What the pressures do to the block.
Wrench resultant(const HexMesh& mesh, const std::vector<FacePressure>& pressures);

}  // namespace tensortopo::scenarios
