// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/level_topology.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/pipeline.hpp"

namespace tensortopo {

namespace {

using Vertex = LevelTopology::Vertex;

}  // namespace

/// @param new_id  of each vertex on an edge or face, its number in the surface
template <class Scalar>
LevelTopology Pipeline<Scalar>::topology(std::span<const Index> new_id) const {
  LevelTopology result;
  std::vector<char> edge_used(complex_.edges.size(), 0), face_used(complex_.faces.size(), 0);
  // By face, the first vertex of each of its arcs' samples.
  const auto first_sample = [&](std::size_t f, std::size_t arc) {
    Index v = face_vertex_[f];
    for (std::size_t a = 0; a < arc; ++a) v += static_cast<Index>((*arcs_[f])[a].samples.size());
    return v;
  };
  const auto smallest_of_closed = [&](std::size_t f, std::size_t arc) {
    const auto first = as_size(first_sample(f, arc));
    Vertex smallest = -1;  // a sample that was taken out has no number
    for (std::size_t i = 0; i < (*arcs_[f])[arc].samples.size(); ++i)
      if (const Vertex v = new_id[first + i]; v >= 0 && (smallest < 0 || v < smallest))
        smallest = v;
    return smallest;
  };
  const auto end_of = [&](std::size_t f, const ArcEnd& end) {
    const auto e = as_size(complex_.face_edges[f][as_size(end.edge)]);
    return new_id[as_size(edge_vertex_[e] + end.crossing)];
  };

  for (std::size_t t = 0; t < tets_.size(); ++t) {
    const auto& state = tets_[t];
    if (!state.proved || state.unresolved || state.patch.triangles.empty()) continue;
    for (const Index e : complex_.tet_edges[t]) edge_used[as_size(e)] = 1;
    for (const Index f : complex_.tet_faces[t]) face_used[as_size(f)] = 1;
    if (state.method == Method::cone) continue;  // see `cone_sheets`
    const auto boundary_arc = [&](const BoundaryArc& piece) {
      const auto f = as_size(complex_.tet_faces[t][as_size(piece.face)]);
      const auto& arc = (*arcs_[f])[as_size(piece.arc)];
      return LevelTopology::BoundaryArc{arc.closed ? smallest_of_closed(f, as_size(piece.arc))
                                                   : end_of(f, piece.forward ? arc.begin : arc.end),
                                        vertices_of(t)[as_size(piece.face)]};
    };
    LevelTopology::Tet tet{complex_.tets[t], {}};
    for (const auto& planned : state.proved->sheets) {
      LevelTopology::Sheet sheet{planned.euler_characteristic, {}};
      for (const int l : planned.loops) {
        std::vector<LevelTopology::BoundaryArc> loop;
        for (const auto& piece : state.proved->loops[as_size(l)])
          loop.push_back(boundary_arc(piece));
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

  for (std::size_t e = 0; e < complex_.edges.size(); ++e) {
    if (!edge_used[e] || !crossings_[e] || crossings_[e]->empty()) continue;
    LevelTopology::Edge edge{complex_.edges[e], {}};
    for (std::size_t k = 0; k < crossings_[e]->size(); ++k) {
      const auto& crossing = (*crossings_[e])[k];
      edge.crossings.push_back({static_cast<double>(crossing.weight), crossing.rising,
                                new_id[as_size(edge_vertex_[e]) + k]});
    }
    result.edges.push_back(std::move(edge));
  }
  for (std::size_t f = 0; f < complex_.faces.size(); ++f) {
    if (!face_used[f] || !arcs_[f] || arcs_[f]->empty()) continue;
    LevelTopology::Face face{complex_.faces[f], {}, {}};
    for (std::size_t a = 0; a < arcs_[f]->size(); ++a) {
      const auto& arc = (*arcs_[f])[a];
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

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template LevelTopology Pipeline<Scalar>::topology(std::span<const Index>) const;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
