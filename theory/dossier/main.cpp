// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_dossier --write FILE | --compare FILE
// Writes the page on all statements, or fails if a file is not that page.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

#include "dossier.hpp"

namespace {

std::string contents(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
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
  const std::string_view what = argc == 3 ? argv[1] : "";
  const std::string page = tensortopo::theory::dossier();
  if (what == "--write") return write(argv[2], page) ? 0 : 4;
  if (what == "--compare") {
    if (contents(argv[2]) == page) return 0;
    std::cerr << "tensortopo_dossier: " << argv[2]
              << " is not what the statements say; build the target theory_readme to write it "
                 "again\n";
    return 1;
  }
  std::cerr << "usage: tensortopo_dossier --write FILE | --compare FILE\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "tensortopo_dossier: " << error.what() << '\n';
  return 4;
}
