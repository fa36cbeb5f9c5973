// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "trace.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

#include "union_find.hpp"

namespace certificate {
namespace {

using Id = Refinement::Id;
using Cell = Refinement::Cell;

bool holds_level(const Refinement& r, const Cell& cell) {
  return !cell.cut && cell.proof != Proof::empty && r.is_crossed(cell);
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

/// The two edges at which the level crosses a triangle, if it does: seen from where the points
/// run counter-clockwise, the larger modes are left of the way from the first to the second.
std::optional<std::array<CrossedEdge, 2>> arc_in(const Refinement& r,
                                                 const std::array<Id, 3>& triangle) {
  const auto above = [&](std::size_t i) { return r.points()[triangle[i]].above; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (above(i) == above(j) || above(i) == above(k)) continue;
    const CrossedEdge next{triangle[i], triangle[j]}, before{triangle[i], triangle[k]};
    if (above(i)) return std::array{next, before};
    return std::array{before, next};
  }
  return std::nullopt;
}

/// The face of a cell opposite its point i, counter-clockwise from outside if the cell is
/// positively oriented.
std::array<Id, 3> outward_face(const Cell& cell, std::size_t i) {
  static constexpr std::array<std::array<std::size_t, 3>, 4> faces{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  return {cell.points[faces[i][0]], cell.points[faces[i][1]], cell.points[faces[i][2]]};
}

unsigned support(const Refinement& r, std::span<const Id> ids) {
  unsigned all = 0;
  for (const Id id : ids) all |= r.points()[id].support;
  return all;
}

}  // namespace

Crossings::Crossings(const Refinement& refinement) : refinement_(refinement) {
  const auto& points = refinement.points();
  for_subsets(refinement.corners(), 2, [&](const auto& ends) {
    const std::size_t a = ends[0], b = ends[1];
    const unsigned edge = 1U << a | 1U << b;
    std::vector<Id> along;
    for (Id i = 0; i < points.size(); ++i)
      if ((points[i].support & ~edge) == 0) along.push_back(i);
    std::sort(along.begin(), along.end(), [&](Id i, Id j) {
      const auto &p = points[i].weights, &q = points[j].weights;
      return p[b] * q[a] < q[b] * p[a];
    });
    unsigned n = 0;
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      if (points[along[i]].above != points[along[i + 1]].above)
        ordinals_[Refinement::key(along[i], along[i + 1])] = n++;
    counts_[edge] = n;
  });
}

unsigned Crossings::count(unsigned edge) const { return counts_.at(edge); }

std::optional<Crossing> Crossings::at(const CrossedEdge& edge) const {
  const auto place = ordinals_.find(Refinement::key(edge[0], edge[1]));
  const unsigned bits = support(refinement_, edge);
  if (place == ordinals_.end() || std::popcount(bits) != 2) return std::nullopt;
  return Crossing{bits, place->second};
}

FaceCurves trace_face(const Refinement& r) {
  Nodes nodes;
  std::vector<std::array<std::size_t, 2>> arcs;
  for (const Cell& cell : r.cells()) {
    if (!holds_level(r, cell)) continue;
    const auto arc = *arc_in(r, {cell.points[0], cell.points[1], cell.points[2]});
    arcs.push_back({nodes.add(arc[0][0], arc[0][1]), nodes.add(arc[1][0], arc[1][1])});
  }
  UnionFind curves(nodes.edges().size());
  for (const auto& [a, b] : arcs) curves.join(a, b);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < nodes.edges().size(); ++i) members[curves.find(i)].push_back(i);

  const Crossings crossings(r);
  FaceCurves result;
  for (const auto& [root, all] : members) {
    std::vector<Crossing> ends;
    std::vector<CrossedEdge> edges;
    for (const std::size_t i : all) {
      edges.push_back(nodes.edges()[i]);
      if (const auto end = crossings.at(edges.back())) ends.push_back(*end);
    }
    if (ends.empty()) {
      result.loops.push_back(std::move(edges));
    } else if (ends.size() == 2) {
      result.arcs.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
    }
  }
  return result;
}

std::optional<std::vector<Sheet>> trace_tet(const Refinement& r) {
  Nodes nodes;
  std::vector<std::vector<std::size_t>> pieces;  // the crossed edges of each cell's disc
  std::set<std::array<std::size_t, 2>> segments;
  struct Rim {
    std::size_t next;
    unsigned face;
  };
  std::map<std::size_t, std::vector<Rim>> rim;
  for (const Cell& cell : r.cells()) {
    if (!holds_level(r, cell)) continue;
    std::vector<std::size_t>& piece = pieces.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<Id, 3> face = outward_face(cell, i);
      const auto arc = arc_in(r, face);
      if (!arc) continue;
      const std::size_t from = nodes.add((*arc)[0][0], (*arc)[0][1]);
      const std::size_t to = nodes.add((*arc)[1][0], (*arc)[1][1]);
      segments.insert({std::min(from, to), std::max(from, to)});
      piece.push_back(from);
      const unsigned bits = support(r, face);
      if (std::popcount(bits) == 3) rim[from].push_back({to, bits});
    }
  }
  UnionFind sheets(nodes.edges().size());
  for (const auto& piece : pieces)
    for (const std::size_t node : piece) sheets.join(piece[0], node);
  std::map<std::size_t, Sheet> found;
  for (std::size_t i = 0; i < nodes.edges().size(); ++i) ++found[sheets.find(i)].euler_characteristic;
  for (const auto& segment : segments) --found[sheets.find(segment[0])].euler_characteristic;
  for (const auto& piece : pieces) ++found[sheets.find(piece[0])].euler_characteristic;

  const Crossings crossings(r);
  while (!rim.empty()) {
    const std::size_t start = rim.begin()->first;
    Loop loop;
    loop.sample = nodes.edges()[start];
    std::size_t at = start;
    do {
      const auto place = rim.find(at);
      if (place == rim.end() || place->second.size() != 1) return std::nullopt;
      const Rim step = place->second[0];
      loop.face = step.face;
      if (const auto crossing = crossings.at(nodes.edges()[at]))
        loop.steps.push_back({*crossing, step.face});
      rim.erase(place);
      at = step.next;
    } while (at != start);
    found[sheets.find(start)].loops.push_back(std::move(loop));
  }
  std::vector<Sheet> result;
  for (auto& [root, sheet] : found) result.push_back(std::move(sheet));
  return result;
}

}  // namespace certificate
