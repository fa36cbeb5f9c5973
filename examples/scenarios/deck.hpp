// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenario.hpp"

namespace tensortopo::scenarios {

/// A number for CalculiX, which reads 20 characters: the shortest decimal that reads back exactly,
/// or, where that is longer, as many digits as fit.
std::string deck_number(double x);

/// How CalculiX solves the equations.
enum class Solver {
  direct,     ///< SPOOLES: balances loads to about 1e-8, with ten times the memory
  iterative,  ///< ITERATIVE SCALING: to about 1e-5. (Its ITERATIVE CHOLESKY is never used: it can
              ///< end without a warning where reactions miss some percent of the load.)
};

/// The input file of CalculiX 2.20: hexahedra of type C3D8I (trilinear, with incompatible modes),
/// nodes and elements numbered from 1 in the order of the mesh.
///
/// Results   everything in float64 as a restart file (.rout); displacements and stresses in
///           float32 (.frd) to check how the former is read; reactions, each and in total (.dat).
std::string deck(const Scenario& scenario, Solver solver);

}  // namespace tensortopo::scenarios
