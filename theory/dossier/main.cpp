// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_dossier --write FILE THEOREMS | --compare FILE THEOREMS | --compare-all FILE THEOREMS
// Writes the page on all statements, or fails if a file is not that page. THEOREMS lists what Coq
// has checked, "id | file | theorem | wording" a line; it may be missing. --compare does not look
// at what the page says of them: a test does that (--compare-all).
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dossier.hpp"

namespace {

std::string contents(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string trimmed(const std::string& words) {
  const auto first = words.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return words.substr(first, words.find_last_not_of(" \t\r") + 1 - first);
}

tensortopo::theory::Theorems theorems_in(const char* file) {
  tensortopo::theory::Theorems result;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    // Bars of the wording are escaped.
    std::vector<std::string> fields(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
        fields.back() += line[++i];
      } else if (line[i] == '|') {
        fields.emplace_back();
      } else {
        fields.back() += line[i];
      }
    }
    if (fields.size() != 4)
      throw std::runtime_error(std::string(file) + ": not four fields: " + line);
    result.push_back(
        {trimmed(fields[0]), trimmed(fields[1]), trimmed(fields[2]), trimmed(fields[3])});
  }
  return result;
}

// Without what it says of theorems.
std::string without_theorems(const std::string& page) {
  static const std::regex lines("- (\\*\\*Coq:\\*\\*|Coq, )[^\n]*\n"), counts("Coq \\([0-9]+\\), "),
      number("[0-9]+ have theorems in Coq");
  std::string rest = std::regex_replace(page, lines, "");
  rest = std::regex_replace(rest, counts, "");
  return std::regex_replace(rest, number, "");
}

bool write(const std::filesystem::path& file, const std::string& words) {
  const std::filesystem::path temporary = file.string() + ".new";
  std::ofstream out(temporary, std::ios::binary);
  out << words;
  out.close();
  if (!out) return false;
  std::filesystem::rename(temporary, file);
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string_view what = argc == 4 ? argv[1] : "";
  const std::string page =
      argc == 4 ? tensortopo::theory::dossier(theorems_in(argv[3])) : std::string();
  if (what == "--write") return write(argv[2], page) ? 0 : 4;
  if (what == "--compare" || what == "--compare-all") {
    const std::string there = contents(argv[2]);
    if (there == page) return 0;
    if (what == "--compare" && without_theorems(there) == without_theorems(page)) return 0;
    std::cerr << "tensortopo_dossier: " << argv[2]
              << " is not what the statements say; build the target theory_readme to write it "
                 "again\n";
    return 1;
  }
  std::cerr << "usage: tensortopo_dossier --write | --compare | --compare-all FILE THEOREMS\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "tensortopo_dossier: " << error.what() << '\n';
  return 4;
}
