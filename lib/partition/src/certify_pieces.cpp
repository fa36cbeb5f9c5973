// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/certify_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// The position of an id among all, ascending.
Index position(const std::vector<std::int64_t>& ids, std::int64_t id) {
  return static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
}

}  // namespace

Extraction extraction_of(const MergedSurface& merged) {
  const auto& cells = merged.cells.cell_ids;
  Extraction result;
  result.surface = merged.surface;
  SurfaceMesh& surface = result.surface;
  for (std::size_t i = 0; i < surface.tet.size(); ++i) {
    surface.tet[i] = position(cells, merged.cell_ids[i]);
    result.statistics.tets_crossed += i == 0 || surface.tet[i] != surface.tet[i - 1];
  }
  for (std::size_t v = 0; v < surface.carrier_vertices.size(); ++v)
    for (std::size_t k = 0; k < 4; ++k)
      if (merged.carrier_ids[v][k] >= 0)
        surface.carrier_vertices[v][k] = position(merged.vertex_ids, merged.carrier_ids[v][k]);
  for (const UnresolvedOwnedCell& cell : merged.unresolved)
    result.unresolved.push_back({position(cells, cell.cell_id), cell.reason});
  for (const std::int64_t id : merged.not_embedded)
    result.not_embedded.push_back(position(cells, id));
  if (merged.topology) result.topology = *merged.topology;
  result.statistics.vertices_on_level = merged.vertices_on_level;
  result.statistics.tets_undefined = merged.tets_undefined;
  return result;
}

CurveExtraction extraction_of(const MergedCurves& merged) {
  const auto& cells = merged.cells.cell_ids;
  CurveExtraction result;
  result.curves = curves_in_cells(merged);
  std::vector<Index> crossed = result.curves.tet;
  std::sort(crossed.begin(), crossed.end());
  result.statistics.tets_crossed =
      as_size(std::unique(crossed.begin(), crossed.end()) - crossed.begin());
  for (const OwnedCurveCell& cell : merged.unresolved)
    result.unresolved.push_back({position(cells, cell.cell_id), cell.obstacle});
  for (const OwnedCurveCell& cell : merged.special)
    result.special.push_back({position(cells, cell.cell_id), cell.obstacle});
  return result;
}

CertifiedLevel certify(const MergedSurface& merged, const ModeValue& mode) {
  if (!merged.topology)
    throw std::invalid_argument(
        "pieces: they were extracted without what a certificate needs (keep_topology)");
  Extraction extraction = extraction_of(merged);
  CertifiedLevel level = certify(merged.cells, mode, extraction);
  level.vertex_ids = merged.vertex_ids;
  level.cell_ids = merged.cells.cell_ids;
  return level;
}

CertifiedCurves certify(const MergedCurves& merged) {
  CertifiedCurves claims = certify(merged.cells, merged.kind, extraction_of(merged));
  claims.vertex_ids = merged.vertex_ids;
  claims.cell_ids = merged.cells.cell_ids;
  return claims;
}

}  // namespace tensortopo
