// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "crossed_cells.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>

#include "owned_part.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("pieces: " + text);
}

std::vector<Index> order_by_id(const TetMesh& mesh) {
  std::vector<Index> order(mesh.tets.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index s, Index t) {
    return mesh.cell_ids[as_size(s)] < mesh.cell_ids[as_size(t)];
  });
  return order;
}

std::int64_t id_of(const UnresolvedOwnedCell& cell) { return cell.cell_id; }
std::int64_t id_of(const OwnedCurveCell& cell) { return cell.cell_id; }
std::int64_t id_of(std::int64_t id) { return id; }

/// Runs of ids as they should be, and what the piece says is about cells that it owns.
template <class Piece>
void require_owned(const Piece& piece) {
  std::int64_t before = -1;
  for (const auto& [first, last] : piece.owned_ids) {
    if (first <= before || last < first) refuse("the ids that one owns are not in order");
    before = last;
  }
  const auto require = [&](std::int64_t id) {
    if (!owns(piece.owned_ids, id))
      refuse("cell " + std::to_string(id) + " is in one that does not own it");
  };
  for (const std::int64_t id : piece.cells.cell_ids) require(id);
  if constexpr (requires { piece.unresolved; })
    for (const auto& cell : piece.unresolved) require(id_of(cell));
  if constexpr (requires { piece.special; })
    for (const auto& cell : piece.special) require(id_of(cell));
}

}  // namespace

std::vector<Index> CrossedCells::ranks_by_id() const {
  return inverse_permutation(order_by_id(mesh));
}

TetMesh CrossedCells::sorted() const {
  TetMesh result{mesh.points, mesh.tensors, {}, {}};
  for (const Index t : order_by_id(mesh)) {
    result.tets.push_back(mesh.tets[as_size(t)]);
    result.cell_ids.push_back(mesh.cell_ids[as_size(t)]);
  }
  return result;
}

template <class Piece>
CrossedCells crossed_cells(std::span<const Piece> pieces) {
  CrossedCells all;
  for (const auto& piece : pieces)
    all.vertex_ids.insert(all.vertex_ids.end(), piece.vertex_ids.begin(), piece.vertex_ids.end());
  std::sort(all.vertex_ids.begin(), all.vertex_ids.end());
  all.vertex_ids.erase(std::unique(all.vertex_ids.begin(), all.vertex_ids.end()),
                       all.vertex_ids.end());
  all.mesh.points.resize(all.vertex_ids.size());
  all.mesh.tensors.resize(all.vertex_ids.size());
  std::vector<char> is_known(all.vertex_ids.size(), 0);
  for (const auto& piece : pieces) {
    auto& numbers = all.vertex_of.emplace_back();
    for (std::size_t v = 0; v < piece.vertex_ids.size(); ++v) {
      const auto place =
          std::lower_bound(all.vertex_ids.begin(), all.vertex_ids.end(), piece.vertex_ids[v]);
      const auto n = static_cast<std::size_t>(place - all.vertex_ids.begin());
      numbers.push_back(static_cast<Index>(n));
      if (is_known[n] != 0 && (!same_bits(all.mesh.points[n], piece.cells.points[v]) ||
                               !same_bits(all.mesh.tensors[n], piece.cells.tensors[v])))
        refuse("vertex " + std::to_string(*place) +
               " has another place or tensor in another piece: they are not of one mesh");
      is_known[n] = 1;
      all.mesh.points[n] = piece.cells.points[v];
      all.mesh.tensors[n] = piece.cells.tensors[v];
    }
    all.first_tet.push_back(all.mesh.tets.size());
    for (auto corners : piece.cells.tets) {
      for (Index& v : corners) v = numbers[as_size(v)];
      all.mesh.tets.push_back(corners);
    }
    all.mesh.cell_ids.insert(all.mesh.cell_ids.end(), piece.cells.cell_ids.begin(),
                             piece.cells.cell_ids.end());
  }
  return all;
}

template <class Piece>
void require_all_cells(std::span<const Piece> pieces) {
  if (pieces.empty()) refuse("there are none");
  const std::int64_t whole = pieces[0].whole_tets;
  std::vector<std::array<std::int64_t, 2>> runs;
  for (const auto& piece : pieces) {
    if (piece.whole_tets != whole)
      refuse("the whole mesh has " + std::to_string(whole) + " cells by one, " +
             std::to_string(piece.whole_tets) + " by another: they are not of one mesh");
    require_owned(piece);
    runs.insert(runs.end(), piece.owned_ids.begin(), piece.owned_ids.end());
  }
  std::sort(runs.begin(), runs.end());
  std::uint64_t owned = 0;  // at most 2^63, as the runs are apart
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0 && runs[i][0] <= runs[i - 1][1])
      refuse("cell " + std::to_string(runs[i][0]) + " is owned by two pieces");
    owned += static_cast<std::uint64_t>(runs[i][1] - runs[i][0]) + 1;
  }
  if (owned != static_cast<std::uint64_t>(whole))
    refuse("they own " + std::to_string(owned) + " of the " + std::to_string(whole) +
           " cells of the whole mesh: a piece is missing");
}

template CrossedCells crossed_cells(std::span<const PieceSurface> pieces);
template CrossedCells crossed_cells(std::span<const SurfaceSeam> seams);
template CrossedCells crossed_cells(std::span<const PieceCurves> pieces);
template CrossedCells crossed_cells(std::span<const CurveSeam> seams);
template CrossedCells crossed_cells(std::span<const NumberedCells> levels);
template void require_all_cells(std::span<const PieceSurface> pieces);
template void require_all_cells(std::span<const SurfaceSeam> seams);
template void require_all_cells(std::span<const PieceCurves> pieces);
template void require_all_cells(std::span<const CurveSeam> seams);

}  // namespace tensortopo
