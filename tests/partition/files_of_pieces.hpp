// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Meshes in pieces as files have them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo::test {

/// The pieces as files have them: with points of their own, numbered anew.
inline std::vector<TetMesh> files_of(const TetMesh& mesh, const std::vector<std::int32_t>& owner,
                              int pieces) {
  std::vector<TetMesh> files(as_size(pieces));
  for (int p = 0; p < pieces; ++p) {
    TetMesh& file = files[as_size(p)];
    std::vector<TetMesh::Index> number(mesh.points.size(), -1);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      if (owner[t] != p) continue;
      auto corners = mesh.tets[t];
      for (TetMesh::Index& v : corners) {
        TetMesh::Index& n = number[as_size(v)];
        if (n < 0) {
          n = static_cast<TetMesh::Index>(file.points.size());
          file.points.push_back(mesh.points[as_size(v)]);
          file.tensors.push_back(mesh.tensors[as_size(v)]);
        }
        v = n;
      }
      file.cell_ids.push_back(static_cast<std::int64_t>(file.tets.size()));
      file.tets.push_back(corners);
    }
  }
  return files;
}

/// All files one after the other, points in one place as one.
inline TetMesh joined(const std::vector<TetMesh>& files) {
  TetMesh whole;
  for (const TetMesh& file : files) {
    std::vector<TetMesh::Index> number;
    for (std::size_t v = 0; v < file.points.size(); ++v) {
      const auto same = std::find(whole.points.begin(), whole.points.end(), file.points[v]);
      number.push_back(static_cast<TetMesh::Index>(same - whole.points.begin()));
      if (same != whole.points.end()) continue;
      whole.points.push_back(file.points[v]);
      whole.tensors.push_back(file.tensors[v]);
    }
    for (auto corners : file.tets) {
      for (TetMesh::Index& v : corners) v = number[as_size(v)];
      whole.cell_ids.push_back(static_cast<std::int64_t>(whole.tets.size()));
      whole.tets.push_back(corners);
    }
  }
  return whole;
}

inline PieceSource source_of(const std::vector<TetMesh>& files) {
  return {static_cast<std::int32_t>(files.size()),
          [&files](std::int32_t p) { return files[as_size(p)]; }};
}

}  // namespace tensortopo::test
