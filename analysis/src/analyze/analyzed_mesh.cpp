// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/analyzed_mesh.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

ReadResult read_analyzed(const std::filesystem::path& input, const ReadOptions& options,
                         AnalyzedMesh& report) {
  ReadResult read = read_mesh(input, options);
  report.input = input;
  report.sha256 = read.sha256;
  report.tensor_name = read.report.tensor_name;
  report.components = read.report.components;
  report.vertices = read.mesh.points.size();
  report.tetrahedra = read.mesh.tets.size();
  report.notes = read.report.all_notes();
  if (std::all_of(read.mesh.tensors.begin(), read.mesh.tensors.end(),
                  [](const auto& t) { return deviator(t) == Deviator<double>{}; }))
    report.notes.emplace_back("all tensors are isotropic: the mode is undefined everywhere");
  return read;
}

nlohmann::ordered_json analyzed_mesh_json(const AnalyzedMesh& mesh) {
  nlohmann::ordered_json json{
      {"path", mesh.input.string()}, {"sha256", mesh.sha256},
      {"vertices", mesh.vertices},   {"tetrahedra", mesh.tetrahedra},
      {"tensor", mesh.tensor_name},  {"components", name_of(mesh.components.order)}};
  if (!mesh.notes.empty()) json["notes"] = mesh.notes;
  return json;
}

}  // namespace tensortopo
