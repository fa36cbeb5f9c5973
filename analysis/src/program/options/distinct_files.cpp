// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/distinct_files.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

struct Named {
  std::string option;
  std::filesystem::path file;
};

std::vector<Named> files_of(const std::vector<CLI::Option*>& options) {
  std::vector<Named> files;
  for (const CLI::Option* option : options)
    for (const std::string& file : option->results())
      files.push_back({option->get_name(), file});
  return files;
}

bool are_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;  // both are there
  const auto first = std::filesystem::weakly_canonical(a, error);
  return !error && first == std::filesystem::weakly_canonical(b, error) && !error;
}

}  // namespace

void require_distinct_files(const CommonOptions& common) {
  std::vector<Named> others = files_of(common.reads);
  for (const Named& written : files_of(common.writes)) {
    for (const Named& other : others)
      if (are_same(written.file, other.file))
        throw UsageError(written.file.string() + ": " + written.option + " and " + other.option +
                         " are the same file");
    others.push_back(written);
  }
}

}  // namespace tensortopo
