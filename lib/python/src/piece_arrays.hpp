// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What pieces of surfaces and of curves have in common, as arrays.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "mesh.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo::python {

inline void require_resolution(double resolution) {
  if (!(resolution > 0) || resolution > 1000)
    throw py::value_error("resolution: must be a positive number, at most 1000");
}

inline MeshPiece piece_of(const Mesh& mesh, const Input<std::int64_t>& vertex_ids,
                          const Input<bool>& owned, std::int64_t whole_cells) {
  MeshPiece piece{mesh.mesh, {}, {}, whole_cells};
  piece.vertex_ids.assign(vertex_ids.data(), vertex_ids.data() + vertex_ids.size());
  for (py::ssize_t t = 0; t < owned.size(); ++t) piece.is_owned.push_back(owned.data()[t]);
  return piece;
}

using MessageRow = std::array<std::int64_t, 5>;

inline std::vector<MessageRow> message_rows(const std::vector<PieceMessage>& messages) {
  std::vector<MessageRow> rows;
  for (const PieceMessage& m : messages)
    rows.push_back(
        {m.from_cell, m.to_cell, m.pass, m.round, std::bit_cast<std::int64_t>(m.digest)});
  return rows;
}

inline std::vector<PieceMessage> messages_of(const std::vector<MessageRow>& rows) {
  std::vector<PieceMessage> messages;
  for (const auto& [from, to, pass, round, digest] : rows)
    messages.push_back({from, to, static_cast<std::int32_t>(pass), static_cast<std::int32_t>(round),
                        std::bit_cast<std::uint64_t>(digest)});
  return messages;
}

template <class Row, class T>
std::vector<Row> rows(const py::dict& piece, const char* name) {
  return rows_of<Row>(piece[name].cast<Input<T>>(), name);
}

template <class T>
std::vector<T> numbers(const py::dict& piece, const char* name) {
  const auto array = piece[name].cast<Input<T>>();
  return {array.data(), array.data() + array.size()};
}

/// The mesh that a piece says something of.
/// @param piece  a surface or curves
template <class Piece>
void put_cells(py::dict& out, Piece& piece) {
  out["cell_points"] = array_of<double>(std::move(piece.cells.points));
  out["cell_tensors"] = array_of<double>(std::move(piece.cells.tensors));
  out["cell_tets"] = array_of<TetMesh::Index>(std::move(piece.cells.tets));
  out["cell_ids"] = array_of<std::int64_t>(std::move(piece.cells.cell_ids));
  out["vertex_ids"] = array_of<std::int64_t>(std::move(piece.vertex_ids));
  out["owned_ids"] = array_of<std::int64_t>(std::move(piece.owned_ids));
  out["whole_cells"] = piece.whole_tets;
  out["told"] = array_of<std::int64_t>(message_rows(piece.told));
  out["heard"] = array_of<std::int64_t>(message_rows(piece.heard));
}

/// What `put_cells` put there.
template <class Piece>
void take_cells(const py::dict& d, Piece& piece) {
  piece.cells.points = rows<Vector3<double>, double>(d, "cell_points");
  piece.cells.tensors = rows<SymmetricTensor<double>, double>(d, "cell_tensors");
  piece.cells.tets = rows<std::array<TetMesh::Index, 4>, TetMesh::Index>(d, "cell_tets");
  piece.cells.cell_ids = numbers<std::int64_t>(d, "cell_ids");
  piece.vertex_ids = numbers<std::int64_t>(d, "vertex_ids");
  piece.owned_ids = rows<std::array<std::int64_t, 2>, std::int64_t>(d, "owned_ids");
  piece.whole_tets = d["whole_cells"].cast<std::int64_t>();
  piece.told = messages_of(rows<MessageRow, std::int64_t>(d, "told"));
  piece.heard = messages_of(rows<MessageRow, std::int64_t>(d, "heard"));
}

}  // namespace tensortopo::python
