// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces and curves in parts, in files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "certificate_check/check_certificate.hpp"
#include "files/files.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/partition/restrict_piece.hpp"

namespace tensortopo::test {

/// Files of a surface or curves in parts, in a folder of their own.
class PartFiles {
 public:
  /// @param role  "surface" or "polylines"
  PartFiles(const std::string& name, std::string role, std::string mode)
      : folder_(std::filesystem::path(testing::TempDir()) / (name + std::to_string(getpid()))),
        role_(std::move(role)),
        mode_(std::move(mode)) {
    std::filesystem::create_directories(folder_);
  }
  ~PartFiles() { std::filesystem::remove_all(folder_); }
  PartFiles(const PartFiles&) = delete;
  PartFiles& operator=(const PartFiles&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }

  /// A part of the mesh with its surface, or curves, and certificate.
  void add(const std::string& field, const std::string& output, const std::string& certificate) {
    const std::string k = std::to_string(parts_.size());
    nlohmann::json entry;
    for (const auto& [role, name, text] :
         {std::array<std::string, 3>{"input", "piece" + k + ".vtu", field},
          std::array<std::string, 3>{role_, "output" + k + ".vtp", output},
          std::array<std::string, 3>{"certificate", "part" + k + ".json", certificate}}) {
      put(name, text);
      entry[role] = {{"file", name}, {"sha256", certificate::sha256_of(text)}};
    }
    parts_.push_back(entry);
  }

  certificate::Report check(const nlohmann::json& whole) const {
    for (const auto& [name, type, role] :
         {std::array<std::string, 3>{"field.pvtu", "PUnstructuredGrid", "input"},
          std::array<std::string, 3>{"output.pvtp", "PPolyData", role_}}) {
      std::string text = "<VTKFile type=\"" + type + "\"><" + type + ">";
      for (const nlohmann::json& part : parts_)
        text += "<Piece Source=\"" + part[role]["file"].get<std::string>() + "\"/>";
      put(name, text + "</" + type + "></VTKFile>");
    }
    put("parts.json", nlohmann::json{{"format", "tensortopo certificate of parts"},
                                     {"version", 1},
                                     {"mode", mode_},
                                     {"parts", parts_},
                                     {"whole", whole}}
                          .dump());
    return certificate::check_certificate(path("field.pvtu"), path("output.pvtp"),
                                          path("parts.json"));
  }

 private:
  std::filesystem::path folder_;
  std::string role_, mode_;
  nlohmann::json parts_ = nlohmann::json::array();
};

/// The tetrahedra of one owner as a mesh of their own.
struct PartMesh {
  TetMesh mesh;
  PartNumbers numbers;
};

/// Vertices are numbered in any order.
inline PartMesh part_mesh(const TetMesh& mesh, const std::vector<std::int32_t>& owner, int which,
                          Random& random) {
  PartMesh part;
  std::map<TetMesh::Index, TetMesh::Index> number;
  std::vector<TetMesh::Index> vertices;
  for (std::size_t t = 0; t < owner.size(); ++t)
    if (owner[t] == which)
      vertices.insert(vertices.end(), mesh.tets[t].begin(), mesh.tets[t].end());
  for (std::size_t i = vertices.size(); i > 1; --i)
    std::swap(vertices[i - 1], vertices[as_size(random.integer(0, static_cast<int>(i) - 1))]);
  for (const auto v : vertices) {
    const auto own = static_cast<TetMesh::Index>(part.mesh.points.size());
    if (!number.try_emplace(v, own).second) continue;
    part.numbers.vertices.push_back({v, own});
    part.mesh.points.push_back(mesh.points[as_size(v)]);
    part.mesh.tensors.push_back(mesh.tensors[as_size(v)]);
  }
  for (std::size_t t = 0; t < owner.size(); ++t) {
    if (owner[t] != which) continue;
    const auto id = static_cast<std::int64_t>(part.mesh.tets.size());
    part.numbers.tets.push_back({static_cast<std::int64_t>(t), id});
    auto corners = mesh.tets[t];
    for (auto& v : corners) v = number.at(v);
    part.mesh.tets.push_back(corners);
    part.mesh.cell_ids.push_back(id);
  }
  return part;
}

}  // namespace tensortopo::test
