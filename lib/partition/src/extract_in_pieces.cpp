// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/extract_in_pieces.hpp"

#include <vector>

#include "agreeing_pieces.hpp"
#include "levels/renumber_level.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/mesh_piece.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

namespace {

/// Ids that are numbers of the mesh.
std::vector<TetMesh::Index> numbers_of(const std::vector<std::int64_t>& ids) {
  std::vector<TetMesh::Index> numbers;
  for (const std::int64_t id : ids) numbers.push_back(static_cast<TetMesh::Index>(id));
  return numbers;
}

/// The extraction that all slabs give together, in the numbers of the mesh.
/// @param extract  extract(piece, options): of one of them
template <class Extract>
auto extract_slabs(const TetMesh& mesh, std::int32_t pieces, const ExtractOptions& options,
                  const Extract& extract) {
  const auto owner = slabs(mesh, pieces);
  const auto all_pieces = [&](int layers) {
    std::vector<decltype(extract(MeshPiece{}, options))> all;
    for (std::int32_t p = 0; p < pieces; ++p) {
      const MeshPiece piece = cut_piece(mesh, owner, p, layers);
      ExtractOptions own = options_of_piece(options, p, pieces);
      own.density.clear();
      if (!options.density.empty())
        for (const std::int64_t t : piece.mesh.cell_ids)
          own.density.push_back(options.density[as_size(t)]);
      all.push_back(extract(piece, own));
    }
    return all;
  };
  // With so many layers as tetrahedra each piece is the whole mesh.
  const auto merged = merge_agreeing_pieces(all_pieces, mesh.tets.size());
  auto result = extraction_of(merged);
  renumber_level(result, numbers_of(merged.vertex_ids), numbers_of(merged.cells.cell_ids));
  return result;
}

}  // namespace

Extraction extract_in_pieces(const TetMesh& mesh, const ModeValue& mode, std::int32_t pieces,
                             const ExtractOptions& options) {
  return extract_slabs(mesh, pieces, options,
                       [&](const MeshPiece& piece, const ExtractOptions& own) {
                         return extract_piece(piece, mode, own);
                       });
}

CurveExtraction extract_in_pieces(const TetMesh& mesh, Degeneracy kind, std::int32_t pieces,
                                  const ExtractOptions& options) {
  return extract_slabs(mesh, pieces, options,
                       [&](const MeshPiece& piece, const ExtractOptions& own) {
                         return extract_curve_piece(piece, kind, own);
                       });
}

}  // namespace tensortopo
