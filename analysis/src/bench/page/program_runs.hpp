// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Whole runs of this program, each as a process of its own.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/page/measurements.hpp"
#include "bench/time_budget.hpp"

namespace tensortopo {

/// A run of this program.
struct ProgramRun {
  double seconds = 0;          ///< by the clock, its start and end included
  std::size_t peak_bytes = 0;  ///< largest resident memory; at least that of the caller
  nlohmann::json report;       ///< what it printed with --json
};

/// Runs this program with --json. Throws IoError if it cannot be started, or ends with another
/// status than 0, or 1 (something undecided).
ProgramRun run_self(std::vector<std::string> arguments);

/// The table of `extract`, `extract --certify` and `check`, files read and written: medians of
/// three runs in turn, of fewer where the budget does not suffice for these. To be called before
/// anything large is in memory, since a process starts with its parent's size.
///
/// The memory of input and output is that of the numbers that they consist of: 72 bytes a vertex
/// and 24 a tetrahedron of the mesh, 112 a vertex and 20 a triangle of the surface.
///
/// @param budget  of which a share of `kProgramsWeight` is taken for each field and mode
std::string programs_table(const MeasurementsCommand& command, TimeBudget& budget,
                           const Progress& progress);
constexpr double kProgramsWeight = 3;

}  // namespace tensortopo
