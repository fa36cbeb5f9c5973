// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenario.hpp"

namespace tensortopo::scenarios {

/// A number for CalculiX, which reads 20 characters: the shortest decimal that reads back exactly,
/// or, where that is longer, as many digits as fit.
std::string deck_number(double x);

/// The input file of CalculiX 2.20: hexahedra of type C3D8I (trilinear, with incompatible modes),
/// nodes and elements numbered from 1 in the order of the mesh.
///
/// Solver    ITERATIVE SCALING. (ITERATIVE CHOLESKY ends well and is wrong: its reactions miss
///           up to some percent of the load. SPOOLES takes ten times the memory.)
/// Results   everything in float64 as a restart file (.rout); displacements and stresses in
///           float32 (.frd) to check how the former is read; reactions, each and in total (.dat).
std::string deck(const Scenario& scenario);

}  // namespace tensortopo::scenarios
