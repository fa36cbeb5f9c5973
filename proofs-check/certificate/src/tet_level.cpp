// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tet_level.hpp"

#include <algorithm>
#include <bit>

#include "monotone_cell.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using Id = Refinement::Id;
using Weights = std::array<mpz_class, 4>;

/// A tetrahedron cut into monotone and empty cells; the level at their edges and faces, each
/// settled by itself; and the pieces in the cells, joined.
class TetLevel {
 public:
  TetLevel(const Level& level, const std::array<Corner, 4>& corners, const Proved<4>& proved,
           const TetBoundary& boundary);

  std::optional<std::vector<Sheet>> sheets();

 private:
  using Face = std::array<Id, 3>;
  /// One arc, or one closed curve, of the boundary of the tetrahedron.
  struct Rim {
    std::size_t next;
    unsigned face;  ///< the roots' bits
  };

  const EdgeLevel& edge(Id a, Id b);
  const FaceLevel& face(const Face& ids);
  unsigned support(const auto& ids) const {
    unsigned all = 0;
    for (const Id id : ids) all |= cells_.points()[id].support;
    return all;
  }
  std::size_t node(Id a, Id b, unsigned ordinal);
  bool number_crossings();
  bool add_cell(const Refinement::Cell& cell);
  std::array<Loop::Sample, 2> beside(std::size_t node) const;
  template <std::size_t Count>
  Loop::Sample sample(const Refinement& part, Id point, const std::array<Id, Count>& roots) const;

  const Level& level_;
  const TetBoundary& boundary_;
  Refinement cells_;
  std::unordered_map<std::uint64_t, EdgeLevel> edges_;
  std::unordered_map<std::uint64_t, FaceLevel> faces_;
  std::map<std::pair<std::uint64_t, unsigned>, std::size_t> node_numbers_;
  /// Crossings of the cells' edges, and closed curves of their faces.
  struct Node {
    std::array<Id, 2> edge{};  ///< none for a closed curve
    unsigned ordinal = 0;
  };
  std::vector<Node> nodes_;
  /// For each edge of a cell on an edge between roots: its crossings there, from the smaller id.
  std::unordered_map<std::uint64_t, std::vector<Crossing>> on_roots_;
  std::map<std::size_t, Rim> rim_;
  std::vector<std::pair<std::size_t, Loop>> closed_;  ///< loops in one cell's face, by their nodes
  std::vector<std::array<std::size_t, 2>> arcs_, joins_;
  std::vector<std::pair<std::size_t, long>> pieces_;  ///< a node, and the Euler characteristic
  std::unordered_map<std::uint64_t, std::size_t> seen_faces_;  ///< their closed curves' first nodes
};

TetLevel::TetLevel(const Level& level, const std::array<Corner, 4>& corners,
                   const Proved<4>& proved, const TetBoundary& boundary)
    : level_(level), boundary_(boundary), cells_(level, corners) {
  cells_.assume(proved);
  std::size_t n = 0;
  for_subsets(4, 2, [&](const auto& m) {
    edges_[Refinement::key(static_cast<Id>(m[0]), static_cast<Id>(m[1]))] = *boundary.edges[n++];
  });
  for (std::size_t f = 0; f < 4; ++f) {
    const auto [i, j, k] = without(f);
    const Face ids{static_cast<Id>(i), static_cast<Id>(j), static_cast<Id>(k)};
    faces_[Refinement::key(ids)] = *boundary.faces[f];
  }
}

const EdgeLevel& TetLevel::edge(Id a, Id b) {
  const auto [place, is_new] = edges_.try_emplace(Refinement::key(a, b));
  if (is_new) place->second = level_in_edge(level_, cells_.corners_at(std::array{a, b}));
  return place->second;
}

/// @pre ids ascend
const FaceLevel& TetLevel::face(const Face& ids) {
  const auto [place, is_new] = faces_.try_emplace(Refinement::key(ids));
  if (is_new)
    place->second = level_in_face(level_, cells_.corners_at(ids),
                                  {&edge(ids[0], ids[1]), &edge(ids[0], ids[2]),
                                   &edge(ids[1], ids[2])});
  return place->second;
}

std::size_t TetLevel::node(Id a, Id b, unsigned ordinal) {
  const auto [place, is_new] =
      node_numbers_.try_emplace({Refinement::key(a, b), ordinal}, nodes_.size());
  if (is_new) nodes_.push_back({{a, b}, ordinal});
  return place->second;
}

/// The crossings along the edges between roots, part by part.
bool TetLevel::number_crossings() {
  const RootEdges root_edges(cells_);
  std::size_t which = 0;
  bool same = true;
  for_subsets(4, 2, [&](const auto& ends) {
    const unsigned bits = 1U << ends[0] | 1U << ends[1];
    const auto& along = root_edges.along(bits);
    unsigned n = 0;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      const Id a = std::min(along[i], along[i + 1]), b = std::max(along[i], along[i + 1]);
      const EdgeLevel& part = edge(a, b);
      same = same && part.decided;
      std::vector<Crossing>& crossings = on_roots_[Refinement::key(a, b)];
      for (unsigned k = 0; k < part.crossings; ++k) crossings.push_back({bits, n++});
      if (a != along[i]) std::reverse(crossings.begin(), crossings.end());
    }
    same = same && n == boundary_.edges[which++]->crossings;
  });
  return same;
}

/// The closed curves on the boundary of a cell, and the pieces of the level that they bound.
bool TetLevel::add_cell(const Refinement::Cell& cell) {
  std::array<Id, 4> ids = cell.points;
  bool is_odd = false;  // against the roots
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      is_odd = is_odd != (cell.points[i] > cell.points[j]);
  std::sort(ids.begin(), ids.end());
  std::array<const FaceLevel*, 4> faces;
  std::map<std::size_t, std::size_t> next;
  std::vector<RimCurve> curves;
  std::vector<std::size_t> on_curve;  // a node of each
  for (std::size_t f = 0; f < 4; ++f) {
    const auto places = without(f);
    const Face corners{ids[places[0]], ids[places[1]], ids[places[2]]};
    const FaceLevel& level = face(corners);
    faces[f] = &level;
    if (!level.decided) return false;
    const unsigned bits = support(corners);
    const bool on_boundary = std::popcount(bits) == 3;
    const auto [first_loop, is_new] =
        seen_faces_.try_emplace(Refinement::key(corners), nodes_.size());
    for (std::size_t i = 0; i < level.loops.size(); ++i) {
      if (is_new) nodes_.emplace_back();
      curves.push_back({in_cell(7, f), i});
      on_curve.push_back(first_loop->second + i);
      if (!on_boundary) continue;
      const auto [p, q] = level.loops[i][0];
      const Refinement& part = *level.refinement;
      closed_.push_back({on_curve.back(),
                         {{}, bits, {sample(part, p, corners), sample(part, q, corners)}}});
    }
    const auto node_at = [&](const Crossing& c) {
      return node(corners.at(static_cast<std::size_t>(std::countr_zero(c.edge))),
                  corners.at(static_cast<std::size_t>(std::bit_width(c.edge) - 1)), c.ordinal);
    };
    for (const auto& arc : level.arcs) {
      std::array ends{node_at(arc[0]), node_at(arc[1])};
      if (is_new) arcs_.push_back(ends);
      if (is_odd != (f % 2 == 1)) std::swap(ends[0], ends[1]);  // seen from outside
      if (!next.emplace(ends[0], ends[1]).second) return false;
      if (on_boundary && !rim_.emplace(ends[0], Rim{ends[1], bits}).second) return false;
    }
  }
  while (!next.empty()) {
    const std::size_t start = next.begin()->first;
    const Node& first = nodes_[start];
    const auto place = [&](Id id) { return std::find(ids.begin(), ids.end(), id) - ids.begin(); };
    curves.push_back({1U << place(first.edge[0]) | 1U << place(first.edge[1]), first.ordinal});
    on_curve.push_back(start);
    for (std::size_t at = start;;) {
      const auto step = next.find(at);
      if (step == next.end()) return false;
      joins_.push_back({start, at});
      at = step->second;
      next.erase(step);
      if (at == start) break;
    }
  }
  if (curves.empty()) return true;  // a piece has a boundary, as it is a graph over a plane
  std::vector<std::size_t> piece_of(curves.size());
  if (curves.size() > 1) {
    auto pieces = pieces_of_cell(level_, cells_, ids, faces, *cell.direction, curves);
    if (!pieces) return false;
    piece_of = std::move(*pieces);
  }
  std::map<std::size_t, std::pair<std::size_t, long>> found;  // planar: 2 less its curves
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto place = found.try_emplace(piece_of[i], on_curve[i], 2).first;
    --place->second.second;
    joins_.push_back({place->second.first, on_curve[i]});
  }
  for (const auto& [number, piece] : found) pieces_.push_back(piece);
  return true;
}

template <std::size_t Count>
Loop::Sample TetLevel::sample(const Refinement& part, Id point,
                              const std::array<Id, Count>& roots) const {
  Loop::Sample result;
  const Refinement::Point& p = part.points()[point];
  result.above = p.above;
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      result.weights[k] += p.weights[i] * cells_.points()[roots[i]].weights[k];
  return result;
}

/// Points at both sides of a crossing.
std::array<Loop::Sample, 2> TetLevel::beside(std::size_t node) const {
  const auto& [edge, ordinal] = nodes_[node];
  Refinement part(level_, cells_.corners_at(edge));
  part.run();
  const RootEdges points(part);
  const std::vector<Id>& along = points.along(3);
  std::array<Loop::Sample, 2> result;
  unsigned n = 0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
    if (part.points()[along[i]].above != part.points()[along[i + 1]].above && n++ == ordinal)
      result = {sample(part, along[i], edge), sample(part, along[i + 1], edge)};
  return result;
}

std::optional<std::vector<Sheet>> TetLevel::sheets() {
  if (!cells_.run() || !number_crossings()) return std::nullopt;
  for (const Refinement::Cell& cell : cells_.cells())
    if (!cell.cut && cell.proof != Proof::empty && !add_cell(cell)) return std::nullopt;

  UnionFind sheets(nodes_.size());
  for (const auto& [a, b] : joins_) sheets.join(a, b);
  std::map<std::size_t, Sheet> found;
  for (const auto& [key, n] : node_numbers_) ++found[sheets.find(n)].euler_characteristic;
  for (const auto& arc : arcs_) --found[sheets.find(arc[0])].euler_characteristic;
  for (const auto& [n, chi] : pieces_) found[sheets.find(n)].euler_characteristic += chi;
  for (auto& [n, loop] : closed_) found[sheets.find(n)].loops.push_back(std::move(loop));
  while (!rim_.empty()) {
    const std::size_t start = rim_.begin()->first;
    Loop loop;
    std::size_t at = start;
    do {
      const auto place = rim_.find(at);
      if (place == rim_.end()) return std::nullopt;
      loop.face = place->second.face;
      const Node& n = nodes_[at];
      const auto on_root = on_roots_.find(Refinement::key(n.edge[0], n.edge[1]));
      if (on_root != on_roots_.end())
        loop.steps.push_back({on_root->second.at(n.ordinal), loop.face});
      at = place->second.next;
      rim_.erase(place);
    } while (at != start);
    if (loop.steps.empty()) loop.beside = beside(start);
    found[sheets.find(start)].loops.push_back(std::move(loop));
  }
  std::vector<Sheet> result;
  for (auto& [root, sheet] : found) result.push_back(std::move(sheet));
  return result;
}

}  // namespace

std::optional<std::vector<Sheet>> level_in_tet(const Level& level,
                                               const std::array<Corner, 4>& corners,
                                               const Proved<4>& proved,
                                               const TetBoundary& boundary) {
  return TetLevel(level, corners, proved, boundary).sheets();
}

}  // namespace certificate
