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
  std::vector<ModeValue> modes;  ///< not negative; of each, the surfaces of M and -M
  int repeat = 5;                ///< timings of each, at least 5; medians are reported
  bool all = false;              ///< other methods at equal error, too
};

/// A page in Markdown: the machine, the commit of the work tree that the program lies in, the date,
/// and for each field and mode seconds by stage beside VTK's contours, the certificate's claims as
/// the independent checker judges them, times and sizes of the programs' runs, degenerate curves,
/// and levels next to 1 and -1. Files go to a temporary folder. Throws UsageError, IoError.
std::string measurements_page(const MeasurementsCommand& command, const Progress& progress = {});

}  // namespace tensortopo
