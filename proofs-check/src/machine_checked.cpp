// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "proof_steps/machine_checked.hpp"

#include <sstream>

#include "machine_checked_page.inc"

namespace proofs {
namespace {

std::string trimmed(const std::string& words) {
  const auto first = words.find_first_not_of(" `");
  if (first == std::string::npos) return {};
  return words.substr(first, words.find_last_not_of(" `") + 1 - first);
}

/// The cells of a row of a table in Markdown; bars in a cell are escaped.
std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '|') {
      result.emplace_back();
    } else if (!result.empty()) {
      const bool escaped = row[i] == '\\' && i + 1 < row.size();
      result.back() += row[escaped ? ++i : i];
    }
  }
  // After the last bar.
  if (!result.empty()) result.pop_back();
  for (std::string& cell : result) cell = trimmed(cell);
  return result;
}

std::vector<MachineChecked> rows_of(const std::string& page) {
  std::vector<MachineChecked> result;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() != '|') continue;
    const std::vector<std::string> row = cells(line);
    if (row.size() != 5 || row[0] == "statement" || row[0].find("--") == 0) continue;
    result.push_back({row[0], row[1], row[2], row[3], row[4]});
  }
  return result;
}

}  // namespace

const std::vector<MachineChecked>& machine_checked() {
  static const std::vector<MachineChecked> all = rows_of(kMachineCheckedPage);
  return all;
}

}  // namespace proofs
