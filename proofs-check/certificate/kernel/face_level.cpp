// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "face_level.hpp"

#include <algorithm>
#include <map>

namespace certificate {
namespace {

using Id = Refinement::Id;

/// The two edges at which the level crosses a triangle of corners i = 0, 1, 2, if it does, by the
/// corners: larger modes are left of the way from the first to the second.
std::optional<std::array<std::array<std::size_t, 2>, 2>> arc_in_triangle(const auto& above) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (above(i) == above(j) || above(i) == above(k)) continue;
    const std::array next{i, j}, before{i, k};
    return above(i) ? std::array{next, before} : std::array{before, next};
  }
  return std::nullopt;
}

/// The arcs of a face in which the level is crossed upwards along d, if the crossings of its edges
/// leave one way to join them; see the README. An entry 0 counts as a small negative one.
std::optional<std::vector<std::array<Crossing, 2>>> arcs_across(
    const std::array<int, 3>& d, const std::array<Corner, 3>& corners,
    const std::array<const EdgeLevel*, 3>& edges) {
  // Lines along d enter the face through one edge and leave it through the two at a corner, the
  // top; or the other way round. Up is left of the way from the left corner to the right one.
  std::size_t apex = 0;
  const auto rises = [&](std::size_t i) { return d[i % 3] > 0; };
  while (rises(apex) == rises(apex + 1) || rises(apex) == rises(apex + 2)) ++apex;
  const bool top = rises(apex);
  const std::size_t left = (apex + (top ? 1 : 2)) % 3, right = (apex + (top ? 2 : 1)) % 3;
  // Crossings from right to left: of the edges where lines enter, and where they leave.
  std::array<std::vector<Crossing>, 2> ahead;
  const auto add = [&](bool leaving, std::size_t a, std::size_t b) {
    for (unsigned n = edges[a + b - 1]->crossings, k = 0; k < n; ++k)
      ahead[leaving].push_back({{std::min(a, b), std::max(a, b)}, a < b ? k : n - 1 - k});
  };
  add(!top, right, left), add(top, right, apex), add(top, apex, left);
  std::vector<std::array<Crossing, 2>> arcs;
  const bool last = !corners[right].above;  // which of the two has the last crossing of an arc
  std::array above{corners[left].above, corners[left].above};
  while (!ahead[0].empty() || !ahead[1].empty()) {
    const bool starts = above[0] == above[1], others_first = ahead[last].size() == 1;
    if (!starts && !others_first && !ahead[!last].empty()) return std::nullopt;
    const bool next = starts ? !above[0] : ahead[!last].empty() ? last : !last;
    if (ahead[next].empty()) return std::nullopt;
    if (starts) arcs.emplace_back();
    arcs.back()[starts ? 0 : 1] = ahead[next].back();
    ahead[next].pop_back();
    above[next] = !above[next];
  }
  if (above[0] != corners[right].above || above[1] != above[0]) return std::nullopt;
  return arcs;
}

/// The crossed parts of an edge between roots, in order.
std::vector<CrossedEdge> crossed_along(const Refinement& r, Id a, Id b) {
  const std::vector<Id> along = points_along(r, a, b);
  std::vector<CrossedEdge> result;
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
    if (r.points()[along[i]].above != r.points()[along[i + 1]].above)
      result.push_back({std::min(along[i], along[i + 1]), std::max(along[i], along[i + 1])});
  return result;
}

/// Joins the arcs of a refined face's triangles. False if one ends inside.
bool trace(const Refinement& r, const std::map<CrossedEdge, Crossing>& ends, FaceLevel& face) {
  std::map<CrossedEdge, CrossedEdge> next;
  for (const Refinement::Cell& cell : r.cells()) {
    if (cell.cut || cell.proof == Proof::empty) continue;
    const auto arc =
        arc_in_triangle([&](std::size_t i) { return r.points()[cell.points[i]].above; });
    const auto edge = [&](const auto& corners) {
      const Id a = cell.points[corners[0]], b = cell.points[corners[1]];
      return CrossedEdge{std::min(a, b), std::max(a, b)};
    };
    if (arc) next[edge((*arc)[0])] = edge((*arc)[1]);
  }
  const auto follow = [&](CrossedEdge at) {
    std::vector<CrossedEdge> passed{at};
    while (const auto step = next.extract(at)) passed.push_back(at = step.mapped());
    return passed;
  };
  for (const auto& [edge, crossing] : ends) {
    if (!next.contains(edge)) continue;
    const auto end = ends.find(follow(edge).back());
    if (end == ends.end()) return false;
    face.arcs.push_back({crossing, end->second});
  }
  while (!next.empty()) {
    face.loops.push_back(follow(next.begin()->first));
    if (face.loops.back().front() != face.loops.back().back()) return false;
    face.loops.back().pop_back();
  }
  return true;
}

}  // namespace

std::vector<Id> points_along(const Refinement& refinement, Id a, Id b) {
  const auto& points = refinement.points();
  std::vector<Id> along;
  for (Id i = 0; i < points.size(); ++i)
    if ((points[i].support & ~(1U << a | 1U << b)) == 0) along.push_back(i);
  std::sort(along.begin(), along.end(), [&](Id i, Id j) {
    const auto &p = points[i].weights, &q = points[j].weights;
    return p[b] * q[a] < q[b] * p[a];
  });
  return along;
}

FaceLevel level_in_face(const Level& level, const std::array<Corner, 3>& corners,
                        const std::array<const EdgeLevel*, 3>& edges, bool is_fine) {
  FaceLevel face;
  const auto proved = level.prove(corners);
  face.decided = proved.proof == Proof::empty;
  for (const EdgeLevel* edge : edges)
    if (face.decided || !edge->decided) return face;
  const bool is_simple = std::all_of(edges.begin(), edges.end(),
                                     [](const EdgeLevel* edge) { return edge->crossings < 2; });
  if (proved.proof == Proof::monotone && (is_simple || !is_fine))
    if (auto arcs = arcs_across(proved.direction, corners, edges))
      return {true, std::move(*arcs), {}, {}};
  const auto refinement = std::make_shared<Refinement>(level, corners);
  refinement->assume(proved);
  constexpr std::array<std::array<Id, 2>, 3> kEnds{{{0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t e = 0; e < 3; ++e)
    refinement->assume(kEnds[e][0], kEnds[e][1], edges[e]->crossings < 2);
  if (!refinement->run()) return face;
  face.decided = true;
  std::map<CrossedEdge, Crossing> ends;
  for (std::size_t e = 0; e < 3; ++e) {
    const auto [a, b] = kEnds[e];
    const std::vector<CrossedEdge> crossed = crossed_along(*refinement, a, b);
    for (unsigned n = 0; n < crossed.size(); ++n) ends[crossed[n]] = {{a, b}, n};
    // Each proves the crossings for itself; a difference would be a mistake here.
    face.decided = face.decided && crossed.size() == edges[e]->crossings;
  }
  face.decided = face.decided && trace(*refinement, ends, face);
  face.refinement = refinement;
  return face;
}

}  // namespace certificate
