// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/renumber_extraction.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "tensortopo/mesh/renumber.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

std::vector<MovedEdge> renumber_edges(std::vector<LevelTopology::Edge>& edges,
                                      std::span<const Index> vertices) {
  std::vector<MovedEdge> moved(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    auto& [ends, crossings] = edges[e];
    for (Index& v : ends) v = vertices[as_size(v)];
    moved[e] = {e, ends[0] > ends[1]};
    if (!moved[e].is_reversed) continue;
    std::swap(ends[0], ends[1]);
    std::reverse(crossings.begin(), crossings.end());
    for (auto& crossing : crossings) {
      std::swap(crossing.weights[0], crossing.weights[1]);
      crossing.rising = !crossing.rising;
    }
  }
  std::sort(moved.begin(), moved.end(), [&](const MovedEdge& p, const MovedEdge& q) {
    return edges[p.from].vertices < edges[q.from].vertices;
  });
  std::vector<LevelTopology::Edge> sorted(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) sorted[e] = std::move(edges[moved[e].from]);
  edges = std::move(sorted);
  return moved;
}

template <class Cell>
void renumber_tets(std::vector<Cell>& cells, std::span<const Index> tets) {
  for (auto& cell : cells) cell.tet = tets[as_size(cell.tet)];
  std::sort(cells.begin(), cells.end(), [](const Cell& p, const Cell& q) { return p.tet < q.tet; });
}

}  // namespace

std::vector<MovedEdge> renumber(Extraction& extraction, std::span<const Index> vertices,
                                std::span<const Index> tets) {
  renumber(extraction.surface, vertices, tets);
  renumber_tets(extraction.unresolved, tets);
  for (Index& t : extraction.not_embedded) t = tets[as_size(t)];
  std::sort(extraction.not_embedded.begin(), extraction.not_embedded.end());
  for (MeshingMessage& message : extraction.messages) {
    message.from = tets[as_size(message.from)];
    message.to = tets[as_size(message.to)];
  }
  std::sort(extraction.messages.begin(), extraction.messages.end());
  auto& topology = extraction.topology;
  for (auto& face : topology.faces) {
    for (Index& v : face.vertices) v = vertices[as_size(v)];
    std::sort(face.vertices.begin(), face.vertices.end());
  }
  std::sort(topology.faces.begin(), topology.faces.end(),
            [](const auto& p, const auto& q) { return p.vertices < q.vertices; });
  for (auto& tet : topology.tets)
    for (auto& sheet : tet.sheets)
      for (auto& loop : sheet.loops)
        for (auto& arc : loop) arc.opposite = vertices[as_size(arc.opposite)];
  renumber_tets(topology.tets, tets);
  renumber_tets(topology.cones, tets);
  return renumber_edges(topology.edges, vertices);
}

}  // namespace tensortopo
