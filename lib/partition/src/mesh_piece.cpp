// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/mesh_piece.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "owned_part.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

void require_distinct(std::vector<std::int64_t> ids, const char* what) {
  std::sort(ids.begin(), ids.end());
  if (!ids.empty() && ids.front() < 0)
    throw std::invalid_argument(std::string("piece: ") + what + " id " +
                                std::to_string(ids.front()) + " is negative");
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end())
    throw std::invalid_argument(std::string("piece: ") + what + " id " + std::to_string(*twice) +
                                " occurs twice");
}

void require_length(std::size_t is, std::size_t should, const char* what) {
  if (is != should)
    throw std::invalid_argument("piece: " + std::to_string(is) + " " + what + " where " +
                                std::to_string(should) + " belong");
}

}  // namespace

void require_sound(const MeshPiece& piece) {
  require_length(piece.vertex_ids.size(), piece.mesh.points.size(), "vertex ids");
  require_length(piece.mesh.tensors.size(), piece.mesh.points.size(), "tensors");
  require_length(piece.mesh.cell_ids.size(), piece.mesh.tets.size(), "cell ids");
  require_length(piece.is_owned.size(), piece.mesh.tets.size(), "marks of ownership");
  require_distinct(piece.vertex_ids, "vertex");
  require_distinct(piece.mesh.cell_ids, "cell");
  if (piece.whole_tets < static_cast<std::int64_t>(piece.mesh.tets.size()))
    throw std::invalid_argument("piece: it has " + std::to_string(piece.mesh.tets.size()) +
                                " tetrahedra, the whole mesh " + std::to_string(piece.whole_tets));
}

MeshPiece cut_piece(const TetMesh& mesh, std::span<const std::int32_t> owner, std::int32_t piece,
                    int layers) {
  std::vector<char> is_held(mesh.tets.size(), 0), is_near(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) is_held[t] = owner[t] == piece;
  const auto note_vertices = [&] {
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (is_held[t])
        for (const Index v : mesh.tets[t]) is_near[as_size(v)] = 1;
  };
  for (int layer = 0; layer < layers; ++layer) {
    note_vertices();
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      is_held[t] = is_held[t] || std::any_of(mesh.tets[t].begin(), mesh.tets[t].end(),
                                             [&](Index v) { return is_near[as_size(v)] != 0; });
  }
  note_vertices();
  if (piece == 0) {
    // Points in no tetrahedron: of no account but for the number of those on the level.
    std::vector<char> is_used(mesh.points.size(), 0);
    for (const auto& tet : mesh.tets)
      for (const Index v : tet) is_used[as_size(v)] = 1;
    for (std::size_t v = 0; v < is_used.size(); ++v) is_near[v] |= is_used[v] == 0;
  }
  MeshPiece result;
  std::vector<Index> number(mesh.points.size(), -1);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (!is_near[v]) continue;
    number[v] = static_cast<Index>(result.mesh.points.size());
    result.mesh.points.push_back(mesh.points[v]);
    result.mesh.tensors.push_back(mesh.tensors[v]);
    result.vertex_ids.push_back(static_cast<std::int64_t>(v));
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!is_held[t]) continue;
    auto corners = mesh.tets[t];
    for (Index& v : corners) v = number[as_size(v)];
    result.mesh.tets.push_back(corners);
    result.mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
    result.is_owned.push_back(owner[t] == piece);
  }
  result.whole_tets = static_cast<std::int64_t>(mesh.tets.size());
  return result;
}

std::vector<std::int32_t> slabs(const TetMesh& mesh, std::int32_t pieces) {
  if (pieces < 1) throw std::invalid_argument("pieces: must be at least 1");
  const std::vector<Index> order = canonical_mesh(mesh).tets;
  std::vector<std::int32_t> owner(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    owner[as_size(order[i])] = static_cast<std::int32_t>(i * as_size(pieces) / order.size());
  return owner;
}

std::vector<std::array<std::int64_t, 2>> owned_ids_of(const MeshPiece& piece) {
  std::vector<std::int64_t> ids;
  for (std::size_t t = 0; t < piece.is_owned.size(); ++t)
    if (piece.is_owned[t] != 0) ids.push_back(piece.mesh.cell_ids[t]);
  return runs_of(std::move(ids));
}

}  // namespace tensortopo
