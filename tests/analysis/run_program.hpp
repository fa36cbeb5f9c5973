// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/folder.hpp"

namespace tensortopo::test {

/// How a run of the program ended, and what it said.
struct Outcome {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string out, err;
};

/// Runs the program tensortopo, without a display, and with no terminal.
Outcome run_program(const std::vector<std::string>& arguments);

/// The same with a standard output that takes nothing, as on a full disk.
Outcome run_without_output(const std::vector<std::string>& arguments);

/// A bundled field: "s1_compress_off", "s2_pushpull", "s3_three" or "s4_slab".
std::string field(const std::string& name);

/// Extracts from s4_slab to s.vtp in the folder, with these words at the end.
Outcome extract_slab(const Folder& folder, std::vector<std::string> words);

std::string contents(const std::filesystem::path& file);

}  // namespace tensortopo::test
