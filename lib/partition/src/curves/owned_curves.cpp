// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "curves/kept_lines.hpp"
#include "curves/piece_vertices.hpp"
#include "owned_part.hpp"
#include "piece_messages.hpp"
#include "tensortopo/partition/piece_curves.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Simplex = std::array<Index, 4>;

/// The vertices, edges and faces of a tetrahedron, ascending; -1 fills up.
std::array<Simplex, 14> simplices_below(std::array<Index, 4> tet) {
  std::sort(tet.begin(), tet.end());
  std::array<Simplex, 14> result{};
  for (unsigned set = 1; set < 15; ++set) {
    Simplex& simplex = result[set - 1];
    simplex.fill(-1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if ((set >> i & 1) != 0) simplex[count++] = tet[i];
  }
  return result;
}

/// Of simplices: which of them a ghost has.
/// @param simplices  ascending, each once
std::vector<char> those_in_ghosts(const MeshPiece& piece, const std::vector<Simplex>& simplices) {
  std::vector<char> result(simplices.size(), 0);
  if (simplices.empty()) return result;
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t) {
    if (piece.is_owned[t] != 0) continue;
    for (const Simplex& simplex : simplices_below(piece.mesh.tets[t])) {
      const auto at = std::lower_bound(simplices.begin(), simplices.end(), simplex);
      if (at != simplices.end() && *at == simplex) result[as_size(at - simplices.begin())] = 1;
    }
  }
  return result;
}

/// @param curves  whose vertices have carriers in numbers of the piece's mesh
std::vector<char> shared_vertices(const MeshPiece& piece, const PieceCurves& part) {
  const auto& carriers = part.curves.carrier_vertices;
  const auto is_end = [&](std::size_t v) {
    return part.keys.vertices[v].kind < CurveVertexKind::in_tet;
  };
  std::vector<Simplex> simplices;
  for (std::size_t v = 0; v < carriers.size(); ++v)
    if (is_end(v)) simplices.push_back(carriers[v]);
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  const auto in_ghosts = those_in_ghosts(piece, simplices);
  std::vector<char> result(carriers.size(), 0);
  for (std::size_t v = 0; v < carriers.size(); ++v)
    if (is_end(v)) {
      const auto at = std::lower_bound(simplices.begin(), simplices.end(), carriers[v]);
      result[v] = in_ghosts[as_size(at - simplices.begin())];
    }
  return result;
}

std::vector<OwnedCurveCell> owned_cells(const MeshPiece& piece,
                                        const std::vector<UnresolvedCurve>& cells) {
  std::vector<OwnedCurveCell> result;
  for (const UnresolvedCurve& cell : cells)
    if (piece.is_owned[as_size(cell.tet)] != 0)
      result.push_back({piece.mesh.cell_ids[as_size(cell.tet)], cell.obstacle});
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.cell_id < b.cell_id; });
  return result;
}

}  // namespace

PieceCurves owned_curves(const MeshPiece& piece, Degeneracy kind, KeyedCurves made) {
  require_sound(piece);
  if (!std::is_sorted(piece.vertex_ids.begin(), piece.vertex_ids.end()))
    throw std::invalid_argument("piece: its vertices are not in the order of their ids; sort them");
  PieceCurves result;
  result.kind = kind;
  result.curves = std::move(made.extraction.curves);
  result.keys = std::move(made.keys);
  result.owned_ids = owned_ids_of(piece);
  result.whole_tets = piece.whole_tets;
  result.unresolved = owned_cells(piece, made.extraction.unresolved);
  result.special = owned_cells(piece, made.extraction.special);
  add_messages(piece, std::exchange(result.keys.messages, {}), result.told, result.heard);
  result.around = lines_around(result.curves, piece.mesh.cell_ids);
  keep_owned_lines(piece, result);
  result.is_shared = shared_vertices(piece, result);
  gather_cells_of_lines(piece, result);
  result.curves.component = components_of_lines(result);
  return result;
}

PieceCurves extract_curve_piece(const MeshPiece& given, Degeneracy kind,
                                const ExtractOptions& options) {
  require_sound(given);
  const MeshPiece piece = in_order_of_ids(given);
  return owned_curves(piece, kind, extract_keyed_curves(piece.mesh, kind, options));
}

}  // namespace tensortopo
