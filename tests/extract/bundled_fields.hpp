// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

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

inline TetMesh read(const std::filesystem::path& file) {
  ReadOptions options;
  options.tetrahedralize = true;
  return read_mesh(file, options).mesh;
}

}  // namespace tensortopo::test
