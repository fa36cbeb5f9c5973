// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What `bench --report` measures.
struct MeasurementsCommand {
  std::vector<std::filesystem::path> inputs;
  ReadOptions read;
  std::vector<ModeValue> modes;         ///< not negative; of each, the surfaces of M and -M
  std::vector<std::string> read_words;  ///< the options that `read` was made of
  int repeat = 5;                       ///< timings of each, if there is time; medians are reported
  double budget = 600;                  ///< seconds for all, see below
  bool all = false;                     ///< other methods at equal error, too
  /// Of these methods (`BenchCommand::comparisons`) those at equal error that a mode is for:
  /// "a_patches" up to 1/2, "hybrid" at 0, others at all.
  std::vector<std::string> only;
};

/// A page in Markdown: the machine, the commit of the work tree that the program lies in, the date,
/// and for each field and mode times, claims, memory and sizes of whole runs of the programs,
/// seconds by stage beside VTK's contours, what a triangle costs, the share of the time that more
/// threads do not shorten, several modes in one run, degenerate curves, and levels next to 1 and
/// -1. Files go to a temporary folder.
///
/// The budget is divided among the measurements. One whose share does not suffice is repeated less
/// often; a comparison at equal error, or the level closest to 1 and -1, is left out then, and the
/// page says so. What is begun is ended, so that the whole can take longer: each measurement that
/// is not left out is made once. Throws UsageError, IoError.
std::string measurements_page(const MeasurementsCommand& command, const Progress& progress = {});

}  // namespace tensortopo
