// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/topology_parts.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <utility>
#include <vector>

#include "differing_pieces.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

template <class Simplex>
void make_set(std::vector<Simplex>& simplices) {
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

/// Lists that are in the order of the surface's vertices, after these got other numbers.
void put_in_order(LevelTopology& topology) {
  for (auto& face : topology.faces) {
    for (auto& arc : face.arcs) std::sort(arc.begin(), arc.end());
    std::sort(face.arcs.begin(), face.arcs.end());
    std::sort(face.loops.begin(), face.loops.end());
  }
  for (auto& tet : topology.tets) {
    for (auto& sheet : tet.sheets) {
      for (auto& loop : sheet.loops)
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
      std::sort(sheet.loops.begin(), sheet.loops.end());
    }
    std::sort(tet.sheets.begin(), tet.sheets.end(),
              [](const auto& p, const auto& q) { return p.loops < q.loops; });
  }
  for (auto& cone : topology.cones) std::sort(cone.sheets.begin(), cone.sheets.end());
}

bool is_same(const LevelTopology::Edge& p, const LevelTopology::Edge& q) {
  return std::equal(p.crossings.begin(), p.crossings.end(), q.crossings.begin(), q.crossings.end(),
                    [](const auto& a, const auto& b) {
                      return a.vertex == b.vertex && a.rising == b.rising &&
                             std::memcmp(&a.weights, &b.weights, sizeof(a.weights)) == 0;
                    });
}
bool is_same(const LevelTopology::Face& p, const LevelTopology::Face& q) {
  return p.arcs == q.arcs && p.loops == q.loops;
}

/// Edges or faces of all parts, each once.
template <class Simplex>
void make_one(std::vector<Simplex>& simplices, std::span<const std::int64_t> vertex_ids) {
  std::stable_sort(simplices.begin(), simplices.end(),
                   [](const auto& p, const auto& q) { return p.vertices < q.vertices; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    if (kept == 0 || simplices[kept - 1].vertices != simplices[i].vertices) {
      if (kept != i) simplices[kept] = std::move(simplices[i]);
      ++kept;
    } else if (!is_same(simplices[kept - 1], simplices[i])) {
      std::vector<std::int64_t> ids;
      for (const Index v : simplices[i].vertices) ids.push_back(vertex_ids[as_size(v)]);
      refuse_simplex("the proofs differ", ids);
    }
  }
  simplices.resize(kept);
}

}  // namespace

LevelTopology topology_of_owned(LevelTopology topology, const MeshPiece& piece) {
  const auto is_ghost = [&](const auto& cell) { return piece.is_owned[as_size(cell.tet)] == 0; };
  std::erase_if(topology.tets, is_ghost);
  std::erase_if(topology.cones, is_ghost);
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 3>> faces;
  const auto note = [&](const auto& cell) {
    auto v = piece.mesh.tets[as_size(cell.tet)];
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) edges.push_back({v[i], v[j]});
      faces.push_back({v[i == 0 ? 1 : 0], v[i < 2 ? 2 : 1], v[i < 3 ? 3 : 2]});
    }
  };
  std::for_each(topology.tets.begin(), topology.tets.end(), note);
  std::for_each(topology.cones.begin(), topology.cones.end(), note);
  make_set(edges), make_set(faces);
  std::erase_if(topology.edges, [&](const auto& edge) {
    return !std::binary_search(edges.begin(), edges.end(), edge.vertices);
  });
  std::erase_if(topology.faces, [&](const auto& face) {
    return !std::binary_search(faces.begin(), faces.end(), face.vertices);
  });
  topology.copies.clear();
  return topology;
}

void renumber_mesh(LevelTopology& topology, std::span<const Index> vertices,
                   std::span<const Index> tets) {
  for (auto& edge : topology.edges)
    for (Index& v : edge.vertices) v = vertices[as_size(v)];
  for (auto& face : topology.faces)
    for (Index& v : face.vertices) v = vertices[as_size(v)];
  for (auto& tet : topology.tets) {
    tet.tet = tets[as_size(tet.tet)];
    for (auto& sheet : tet.sheets)
      for (auto& loop : sheet.loops)
        for (auto& arc : loop) arc.opposite = vertices[as_size(arc.opposite)];
  }
  for (auto& cone : topology.cones) cone.tet = tets[as_size(cone.tet)];
}

LevelTopology merge_topologies(std::span<const TopologyPart> parts,
                               std::span<const std::int64_t> vertex_ids) {
  LevelTopology whole;
  const auto append = [](auto& list, auto& more) {
    list.insert(list.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
  };
  for (const TopologyPart& part : parts) {
    LevelTopology own = *part.topology;
    renumber_mesh(own, part.vertices, part.tets);
    for_each_surface_vertex(own, [&](Index& v) { v = part.surface_vertices[as_size(v)]; });
    put_in_order(own);
    append(whole.edges, own.edges), append(whole.faces, own.faces);
    append(whole.tets, own.tets), append(whole.cones, own.cones);
  }
  make_one(whole.edges, vertex_ids);
  make_one(whole.faces, vertex_ids);
  const auto by_tet = [](const auto& p, const auto& q) { return p.tet < q.tet; };
  std::sort(whole.tets.begin(), whole.tets.end(), by_tet);
  std::sort(whole.cones.begin(), whole.cones.end(), by_tet);
  return whole;
}

}  // namespace tensortopo
