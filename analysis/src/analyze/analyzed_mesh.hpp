// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// What the report of an analysis says of its mesh.
struct AnalyzedMesh {
  std::filesystem::path input;
  std::string sha256, tensor_name;
  std::size_t vertices = 0, tetrahedra = 0;
  TensorComponents components;     ///< in the input
  std::vector<std::string> notes;  ///< of reading
  Provenance provenance;           ///< of files that are written
};

/// Reads a mesh, and says in the report what there is to say of it. Throws IoError.
ReadResult read_analyzed(const std::filesystem::path& input, const ReadOptions& options,
                         AnalyzedMesh& report);

/// The same as a JSON object.
nlohmann::ordered_json analyzed_mesh_json(const AnalyzedMesh& mesh);

}  // namespace tensortopo
