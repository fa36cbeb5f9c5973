// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/trials.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::test {

/// The bundled stress fields: what a finite element program wrote, rounding, symmetries and all.
inline std::vector<std::filesystem::path> bundled_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TENSORTOPO_EXAMPLE_DATA))
    if (entry.path().extension() == ".vtu") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// All of them, or in the short suite every other.
inline std::vector<std::filesystem::path> tried_files() {
  std::vector<std::filesystem::path> files = bundled_files();
  Share share(2);
  std::erase_if(files, [&](const auto&) { return !share.has("field"); });
  return files;
}

/// The one whose name begins so ("s1"). Throws std::runtime_error unless there is exactly one: a
/// test of a field that was renamed must not pass for want of one.
inline std::filesystem::path bundled_file(const std::string& name) {
  std::vector<std::filesystem::path> found;
  for (const auto& file : bundled_files())
    if (file.filename().string().rfind(name + '_', 0) == 0) found.push_back(file);
  if (found.size() != 1)
    throw std::runtime_error(std::to_string(found.size()) + " bundled fields are called " + name);
  return found.front();
}

inline TetMesh read(const std::filesystem::path& file) {
  ReadOptions options;
  options.tetrahedralize = true;
  return read_mesh(file, options).mesh;
}

}  // namespace tensortopo::test
