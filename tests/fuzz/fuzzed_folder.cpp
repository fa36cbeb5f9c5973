// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzzed_folder.hpp"

#include <stdlib.h>  // mkdtemp

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace tensortopo::test {

FuzzedFolder::FuzzedFolder() {
  const std::filesystem::path memory = "/dev/shm";
  std::string name =
      ((std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path()) /
       "tensortopo-fuzz-XXXXXX")
          .string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

FuzzedFolder::~FuzzedFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string FuzzedFolder::put(const char* name, std::string_view bytes) const {
  const std::string file = path_ / name;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

const FuzzedFolder& fuzzed_folder() {
  static const FuzzedFolder folder;
  return folder;
}

}  // namespace tensortopo::test
