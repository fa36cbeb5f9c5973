// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/sweep/sweep.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// A mode between two critical values of a sweep.
struct ModeToCheck {
  std::size_t interval = 0;  ///< that holds it
  ModeValue mode;
};

/// Modes at which a sweep is to be checked.
struct ModesToCheck {
  std::vector<ModeToCheck> modes;  ///< ascending, each once
  std::size_t events = 0;          ///< critical values that they are next to
  std::vector<std::string> none;   ///< ranges without a double, in words
};

/// For each of `most` / 4 critical values (at least one), evenly spread over the list of them (or
/// for all if there are no more), four modes: about the middles of the intervals before and after,
/// and in these next to the critical value, about a thousandth of the interval away. Without
/// critical values the middle of the range.
ModesToCheck modes_to_check(const Sweep& sweep, std::size_t most);

/// A level of the check, and what was found of it.
struct CheckedLevel {
  std::size_t interval = 0;
  SweepLevel level;
};

/// What a comparison of a sweep with certified surfaces came to.
struct SweepCheck {
  std::vector<CheckedLevel> levels;         ///< by mode
  std::size_t events = 0;                   ///< critical values of the sweep
  std::size_t compared = 0;                 ///< of these, those passed by two resolved levels
  std::size_t certified = 0;                ///< claims that the checker confirms
  std::vector<std::string> contradictions;  ///< in words; there should be none
  std::vector<std::string> undecided;       ///< what could not be compared or confirmed, in words
};

/// Compares levels with a sweep. Of levels without unresolved tetrahedra
/// (1) all in one interval have the same components, Euler characteristic and boundary loops;
/// (2) the Euler characteristic is the one that the sweep gives for the interval;
/// (3) from one interval to the next each number grows as the critical points between allow.
/// What contradicts this, and what cannot be compared, is added to `check`.
/// @param check  with `levels`
void compare_levels(const Sweep& sweep, SweepCheck& check);

/// Extracts the surfaces of `modes_to_check`, writes a certificate of each, has it checked by the
/// independent checker, and compares the surfaces with the sweep. Files go to a temporary folder.
/// @param input  the file that the sweep was made of, read in the same way
/// Throws UsageError if the file has numbers that no certificate describes or if the program was
/// built without the checker, IoError.
SweepCheck check_sweep(const Sweep& sweep, const std::filesystem::path& input,
                       const ReadOptions& read, std::size_t modes, const Progress& progress = {});

}  // namespace tensortopo
