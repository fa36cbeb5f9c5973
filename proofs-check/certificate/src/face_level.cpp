// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "face_level.hpp"

#include <algorithm>
#include <bit>

#include "union_find.hpp"

namespace certificate {
namespace {

using Id = Refinement::Id;

/// The two edges at which the level crosses a triangle of corners i = 0, 1, 2, if it does, by the
/// corners: larger modes are left of the way from the first to the second.
template <class Above>
std::optional<std::array<std::array<std::size_t, 2>, 2>> arc_in_triangle(const Above& above) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (above(i) == above(j) || above(i) == above(k)) continue;
    const std::array next{i, j}, before{i, k};
    if (above(i)) return std::array{next, before};
    return std::array{before, next};
  }
  return std::nullopt;
}

/// Crossed edges, numbered.
class Nodes {
 public:
  std::size_t add(Id a, Id b) {
    const auto [place, is_new] = numbers_.try_emplace(Refinement::key(a, b), edges_.size());
    if (is_new) edges_.push_back({a, b});
    return place->second;
  }
  const std::vector<CrossedEdge>& edges() const { return edges_; }

 private:
  std::unordered_map<std::uint64_t, std::size_t> numbers_;
  std::vector<CrossedEdge> edges_;
};

/// Joins the arcs of a refined face's triangles.
void trace(const Refinement& r, const RootEdges& root_edges, FaceLevel& face) {
  Nodes nodes;
  std::vector<std::array<std::size_t, 2>> arcs;
  for (const Refinement::Cell& cell : r.cells()) {
    if (cell.cut || cell.proof == Proof::empty) continue;
    const auto arc =
        arc_in_triangle([&](std::size_t i) { return r.points()[cell.points[i]].above; });
    if (!arc) continue;
    const auto node = [&](const auto& edge) {
      return nodes.add(cell.points[edge[0]], cell.points[edge[1]]);
    };
    const std::size_t from = node((*arc)[0]);
    arcs.push_back({from, node((*arc)[1])});
  }
  UnionFind curves(nodes.edges().size());
  std::vector<char> starts(nodes.edges().size());
  for (const auto& [from, to] : arcs) curves.join(from, to), starts[from] = 1;
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < nodes.edges().size(); ++i) members[curves.find(i)].push_back(i);
  for (const auto& [root, all] : members) {
    std::array<std::optional<Crossing>, 2> ends;
    std::vector<CrossedEdge> edges;
    for (const std::size_t i : all) {
      edges.push_back(nodes.edges()[i]);
      if (const auto end = root_edges.at(edges.back())) ends[starts[i] != 0 ? 0 : 1] = end;
    }
    if (ends[0] && ends[1]) {
      face.arcs.push_back({*ends[0], *ends[1]});
    } else {
      face.loops.push_back(std::move(edges));
    }
  }
}

}  // namespace

RootEdges::RootEdges(const Refinement& refinement) {
  const auto& points = refinement.points();
  for_subsets(refinement.corners(), 2, [&](const auto& ends) {
    const std::size_t a = ends[0], b = ends[1];
    const unsigned edge = 1U << a | 1U << b;
    std::vector<Id>& along = along_[edge];
    for (Id i = 0; i < points.size(); ++i)
      if ((points[i].support & ~edge) == 0) along.push_back(i);
    std::sort(along.begin(), along.end(), [&](Id i, Id j) {
      const auto &p = points[i].weights, &q = points[j].weights;
      return p[b] * q[a] < q[b] * p[a];
    });
    unsigned n = 0;
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      if (points[along[i]].above != points[along[i + 1]].above)
        crossings_[Refinement::key(along[i], along[i + 1])] = {edge, n++};
    counts_[edge] = n;
  });
}

std::optional<Crossing> RootEdges::at(const CrossedEdge& edge) const {
  const auto place = crossings_.find(Refinement::key(edge[0], edge[1]));
  return place == crossings_.end() ? std::nullopt : std::optional(place->second);
}

EdgeLevel level_in_edge(const Level& level, const std::array<Corner, 2>& corners) {
  const auto proved = level.prove(corners);
  if (proved.proof != Proof::open)
    return {true, proved.proof, corners[0].above != corners[1].above ? 1U : 0U};
  Refinement refinement(level, corners);
  if (!refinement.run()) return {};
  return {true, Proof::open, RootEdges(refinement).count(3)};
}

FaceLevel level_in_face(const Level& level, const std::array<Corner, 3>& corners,
                        const std::array<const EdgeLevel*, 3>& edges) {
  FaceLevel face;
  const auto proved = level.prove(corners);
  face.decided = proved.proof == Proof::empty;
  bool is_simple = proved.proof == Proof::monotone;
  for (const EdgeLevel* edge : edges) {
    if (face.decided || !edge->decided) return face;
    is_simple = is_simple && edge->proof != Proof::open;
  }
  if (is_simple) {
    face.decided = true;
    const auto arc = arc_in_triangle([&](std::size_t i) { return corners[i].above; });
    const auto on = [](const auto& edge) { return Crossing{1U << edge[0] | 1U << edge[1], 0}; };
    if (arc) face.arcs.push_back({on((*arc)[0]), on((*arc)[1])});
    return face;
  }
  auto refinement = std::make_shared<Refinement>(level, corners);
  refinement->assume(proved);
  refinement->assume(0, 1, edges[0]->proof);
  refinement->assume(0, 2, edges[1]->proof);
  refinement->assume(1, 2, edges[2]->proof);
  if (!refinement->run()) return face;
  const RootEdges root_edges(*refinement);
  trace(*refinement, root_edges, face);
  // Each proves the crossings for itself; a difference would be a mistake here.
  face.decided = root_edges.count(3) == edges[0]->crossings &&
                 root_edges.count(5) == edges[1]->crossings &&
                 root_edges.count(6) == edges[2]->crossings;
  if (!face.loops.empty()) face.refinement = std::move(refinement);
  return face;
}

}  // namespace certificate
