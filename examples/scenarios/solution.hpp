// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "scenario.hpp"
#include "surface_pressure.hpp"

namespace tensortopo::scenarios {

/// A result that must not be used.
class BadSolution : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How well a solution balances its loads, and how well it was read.
struct SolutionChecks {
  Wrench load, reaction;
  double load_size = 0;         ///< sum of the loads' magnitudes, N
  double force_imbalance = 0;   ///< |load + reaction| / load_size
  double moment_imbalance = 0;  ///< that of the moments, / (load_size * diagonal of the mesh)
  double largest_stress = 0;    ///< component at a node, MPa
  /// Largest difference from the .frd file, with CalculiX's rounded weights, by the largest
  /// component.
  double frd_stress = 0, frd_displacement = 0;
  double weights = 0;  ///< what those weights change, by the largest component
};

/// Reactions may miss the loads by so much. (ITERATIVE SCALING misses some millionths.)
inline constexpr double kLargestImbalance = 1e-3;
/// The .frd file has float32.
inline constexpr double kLargestFrdDifference = 1e-6;

struct Solution {
  TetMesh field;
  SolutionChecks checks;
};

/// The field of a scenario from the files JOB.rout, JOB.frd and JOB.dat that CalculiX left.
///
/// Throws  IoError for a file that is missing or damaged; BadSolution if it is of another mesh, if
///         reactions and loads differ by more than kLargestImbalance, in force or in moment, or if
///         .rout and .frd differ by more than kLargestFrdDifference.
Solution read_solution(const Scenario& scenario, const std::filesystem::path& job);

/// A few lines for people. Ends with a newline.
std::string to_text(const SolutionChecks& checks);

}  // namespace tensortopo::scenarios
