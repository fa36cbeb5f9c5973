// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/extract_in_pieces.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tensortopo/partition/mesh_piece.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

namespace {

/// The options for one piece: denser samples by its own numbers, progress by pieces.
ExtractOptions options_of(const ExtractOptions& options, const MeshPiece& piece,
                          std::int32_t number, std::int32_t pieces) {
  ExtractOptions own = options;
  own.density.clear();
  if (!options.density.empty())
    for (const std::int64_t t : piece.mesh.cell_ids)
      own.density.push_back(options.density[as_size(t)]);
  if (options.progress)
    own.progress = [&options, label = "piece " + std::to_string(number + 1) + " of " +
                                      std::to_string(pieces) +
                                      ": "](std::string_view stage, double fraction) {
      options.progress(label + std::string(stage), fraction);
    };
  return own;
}

}  // namespace

Extraction extract_in_pieces(const TetMesh& mesh, const ModeValue& mode, std::int32_t pieces,
                             const ExtractOptions& options) {
  const auto owner = slabs(mesh, pieces);
  MergedSurface merged;
  for (int layers = 1;; ++layers) {
    std::vector<PieceSurface> surfaces;
    for (std::int32_t p = 0; p < pieces; ++p) {
      const MeshPiece piece = cut_piece(mesh, owner, p, layers);
      surfaces.push_back(extract_piece(piece, mode, options_of(options, piece, p, pieces)));
    }
    try {
      merged = merge_pieces(surfaces);
      break;
    } catch (const PiecesDiffer&) {
      // With so many layers each piece is the whole mesh.
      if (as_size(layers) > mesh.tets.size()) throw;
    }
  }
  Extraction result;
  result.surface = std::move(merged.surface);
  for (const UnresolvedOwnedCell& cell : merged.unresolved)
    result.unresolved.push_back({static_cast<TetMesh::Index>(cell.cell_id), cell.reason});
  for (const std::int64_t id : merged.not_embedded)
    result.not_embedded.push_back(static_cast<TetMesh::Index>(id));
  const auto& tets = result.surface.tet;
  for (std::size_t i = 0; i < tets.size(); ++i)
    result.statistics.tets_crossed += i == 0 || tets[i] != tets[i - 1];
  return result;
}

}  // namespace tensortopo
