// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/extract_in_pieces.hpp"

#include <vector>

#include "agreeing_pieces.hpp"
#include "tensortopo/mesh/renumber.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/mesh_piece.hpp"
#include "tensortopo/partition/piece_surface.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

namespace {

/// Ids that are numbers of the mesh.
std::vector<TetMesh::Index> numbers_of(const std::vector<std::int64_t>& ids) {
  std::vector<TetMesh::Index> numbers;
  for (const std::int64_t id : ids) numbers.push_back(static_cast<TetMesh::Index>(id));
  return numbers;
}

}  // namespace

Extraction extract_in_pieces(const TetMesh& mesh, const ModeValue& mode, std::int32_t pieces,
                             const ExtractOptions& options) {
  const auto owner = slabs(mesh, pieces);
  const auto surfaces = [&](int layers) {
    std::vector<PieceSurface> all;
    for (std::int32_t p = 0; p < pieces; ++p) {
      const MeshPiece piece = cut_piece(mesh, owner, p, layers);
      ExtractOptions own = options_of_piece(options, p, pieces);
      own.density.clear();
      if (!options.density.empty())
        for (const std::int64_t t : piece.mesh.cell_ids)
          own.density.push_back(options.density[as_size(t)]);
      all.push_back(extract_piece(piece, mode, own));
    }
    return all;
  };
  // With so many layers as tetrahedra each piece is the whole mesh.
  const MergedSurface merged = merge_agreeing_pieces(surfaces, mesh.tets.size());
  Extraction result = extraction_of(merged);
  const auto tets = numbers_of(merged.cells.cell_ids);
  renumber(result.surface, numbers_of(merged.vertex_ids), tets);
  for (UnresolvedCell& cell : result.unresolved) cell.tet = tets[as_size(cell.tet)];
  for (TetMesh::Index& t : result.not_embedded) t = tets[as_size(t)];
  renumber_mesh(result.topology, numbers_of(merged.vertex_ids), tets);
  return result;
}

}  // namespace tensortopo
