// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/proved_topology.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;
using Vertex = LevelTopology::Vertex;

}  // namespace

template <class Scalar>
LevelTopology proved_topology(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                              std::span<const CellProof<Scalar>> proofs,
                              const CellMeshes<Scalar>& meshes, std::span<const Index> new_id) {
  const auto& arcs_of = meshes.boundary.arcs;
  const auto& rows = meshes.boundary.crossings.rows;
  const auto& first_of_face = meshes.vertices.of_face;
  LevelTopology result;
  std::vector<char> edge_used(cells.edges.size(), 0), face_used(cells.faces.size(), 0);
  // By face, the first vertex of each of its arcs' samples.
  const auto first_sample = [&](std::size_t f, std::size_t arc) {
    Index v = first_of_face[f];
    for (std::size_t a = 0; a < arc; ++a) v += static_cast<Index>(arcs_of[f][a].samples.size());
    return v;
  };
  const auto smallest_of_closed = [&](std::size_t f, std::size_t arc) {
    const auto first = as_size(first_sample(f, arc));
    Vertex smallest = -1;  // a sample that was taken out has no number
    for (std::size_t i = 0; i < arcs_of[f][arc].samples.size(); ++i)
      if (const Vertex v = new_id[first + i]; v >= 0 && (smallest < 0 || v < smallest))
        smallest = v;
    return smallest;
  };
  const auto end_of = [&](std::size_t f, const ArcEnd& end) {
    const auto e = as_size(cells.face_edges[f][as_size(end.edge)]);
    return new_id[rows.first(e) + as_size(end.crossing)];
  };

  for (std::size_t t = 0; t < proofs.size(); ++t) {
    const auto& proved = proofs[t].topology;
    const auto& mesh = meshes.cells[t];
    if (!proved || mesh.unresolved || mesh.patch.triangles.empty()) continue;
    for (const Index e : cells.tet_edges[t]) edge_used[as_size(e)] = 1;
    for (const Index f : cells.tet_faces[t]) face_used[as_size(f)] = 1;
    if (mesh.mesher == Mesher::cone) continue;  // see `cone_sheets`
    const auto boundary_arc = [&](const BoundaryArc& piece) {
      const auto f = as_size(cells.tet_faces[t][as_size(piece.face)]);
      const auto& arc = arcs_of[f][as_size(piece.arc)];
      return LevelTopology::BoundaryArc{arc.closed ? smallest_of_closed(f, as_size(piece.arc))
                                                   : end_of(f, piece.forward ? arc.begin : arc.end),
                                        input.vertices_of(cells, t)[as_size(piece.face)]};
    };
    LevelTopology::Tet tet{cells.tets[t], {}};
    for (const auto& known : proved->sheets) {
      LevelTopology::Sheet sheet{known.euler_characteristic, {}};
      for (const int l : known.loops) {
        std::vector<LevelTopology::BoundaryArc> loop;
        for (const auto& piece : proved->loops[as_size(l)]) loop.push_back(boundary_arc(piece));
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        sheet.loops.push_back(std::move(loop));
      }
      std::sort(sheet.loops.begin(), sheet.loops.end());
      tet.sheets.push_back(std::move(sheet));
    }
    std::sort(tet.sheets.begin(), tet.sheets.end(),
              [](const auto& p, const auto& q) { return p.loops < q.loops; });
    result.tets.push_back(std::move(tet));
  }

  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    if (!edge_used[e] || rows[e].empty()) continue;
    LevelTopology::Edge edge{cells.edges[e], {}};
    for (std::size_t k = 0; k < rows[e].size(); ++k) {
      const auto& crossing = rows[e][k];
      const auto weight = static_cast<double>(crossing.weight);
      edge.crossings.push_back({{1 - weight, weight}, crossing.rising, new_id[rows.first(e) + k]});
    }
    result.edges.push_back(std::move(edge));
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (!face_used[f] || arcs_of[f].empty()) continue;
    LevelTopology::Face face{cells.faces[f], {}, {}};
    for (std::size_t a = 0; a < arcs_of[f].size(); ++a) {
      const auto& arc = arcs_of[f][a];
      if (arc.closed) {
        face.loops.push_back(smallest_of_closed(f, a));
        continue;
      }
      const Vertex v = end_of(f, arc.begin), w = end_of(f, arc.end);
      face.arcs.push_back({std::min(v, w), std::max(v, w)});
    }
    std::sort(face.arcs.begin(), face.arcs.end());
    std::sort(face.loops.begin(), face.loops.end());
    result.faces.push_back(std::move(face));
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                    \
  template LevelTopology proved_topology(                                                 \
      const SurfaceInput<Scalar>&, const TetComplex&, std::span<const CellProof<Scalar>>, \
      const CellMeshes<Scalar>&, std::span<const TetMesh::Index>);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
