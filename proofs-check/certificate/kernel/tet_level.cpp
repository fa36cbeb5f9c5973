// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tet_level.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <utility>

#include "places.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using Id = Refinement::Id;
using Corners = std::array<Id, 4>;  ///< of a cell, ascending
using Join = std::array<std::size_t, 2>;
using Sides = std::array<std::size_t, 2>;  ///< a node below and one above a part of the level

/// The part between two crossings, or a crossing and an end, is a node each.
struct EdgePart {
  EdgeLevel level;
  std::size_t first = 0;
  std::array<Join, 2> joins{};  ///< with its ends
};
struct FacePart {
  std::array<Id, 3> corners{};
  FaceLevel level;
  std::size_t first = 0;  ///< nodes of the points of its refinement; without one it has none
  std::vector<Join> joins;
};

/// The classes of two nodes.
Sides sides_in(auto& classes, const Sides& s) {
  return {classes.find(s[0]), classes.find(s[1])};
}

Sides beside_curve(const FacePart& part, const std::vector<CrossedEdge>& curve) {
  const std::size_t a = part.first + curve[0][0], b = part.first + curve[0][1];
  return part.level.refinement->points()[curve[0][0]].above ? Sides{b, a} : Sides{a, b};
}

bool is_inside(const Place<3>& p) { return p[0] >= 0 && p[1] >= 0 && p[2] >= 0; }

class Regions {
 public:
  /// @param is_fine  all faces with an edge that is crossed twice are cut
  Regions(const Level& level, const Refinement& cells, const TetBoundary& boundary, bool is_fine)
      : level_(level), cells_(cells), boundary_(boundary), is_fine_(is_fine) {}
  std::optional<std::vector<Sheet>> sheets(const std::vector<RimCurve>& curves);

 private:
  struct Piece {
    Sides sides;
    long euler_characteristic;
  };

  EdgePart& edge(Id a, Id b);
  FacePart& face(const std::array<Id, 3>& corners);
  std::size_t new_nodes(std::size_t count) { return (nodes_ += count) - count; }
  bool is_above(Id point) const { return cells_.points()[point].above; }
  Sides beside(const EdgePart& part, Id start, std::size_t crossing) const;
  Sides beside(const FacePart& part, const Crossing& crossing);
  bool add_cell(const Refinement::Cell& cell);
  bool join_along(const Refinement::Weights& direction, const Corners& corners,
                  SparseUnionFind& around, const auto& join);
  bool number_crossings();
  std::optional<std::size_t> find(const FacePart& part, const Place<3>& place, bool above) const;
  std::optional<std::size_t> find(std::size_t opposite, const Place<3>& place, bool above);
  std::optional<Sides> sides_of(const RimCurve& curve);

  const Level& level_;
  const Refinement& cells_;
  const TetBoundary& boundary_;
  const bool is_fine_;
  std::unordered_map<std::uint64_t, EdgePart> edges_;
  std::unordered_map<std::uint64_t, FacePart> faces_;
  std::size_t nodes_ = 0;  ///< the first are the points of the cells
  UnionFind all_;
  std::map<unsigned, std::vector<Sides>> on_roots_;  ///< crossings of the edges between roots
  std::vector<Piece> pieces_;
};

/// @pre a < b
EdgePart& Regions::edge(Id a, Id b) {
  const auto [place, is_new] = edges_.try_emplace(Refinement::key(a, b));
  EdgePart& part = place->second;
  if (!is_new) return part;
  part.level = b < 4 ? *boundary_.edges[a + b * (b - 1) / 2]
                     : level_in_edge(level_, cells_.corners_at(std::array{a, b}));
  part.first = new_nodes(part.level.crossings + 1);
  part.joins = {Join{a, part.first}, Join{b, part.first + part.level.crossings}};
  return part;
}

/// @pre the corners ascend
FacePart& Regions::face(const std::array<Id, 3>& corners) {
  const auto [place, is_new] = faces_.try_emplace(Refinement::key(corners));
  FacePart& part = place->second;
  if (!is_new) return part;
  const auto& [a, b, c] = corners;
  part.corners = corners;
  const std::array<const EdgeLevel*, 3> edges{&edge(a, b).level, &edge(a, c).level,
                                              &edge(b, c).level};
  part.level = c < 4 && !is_fine_
                   ? *boundary_.faces[6 - a - b - c]
                   : level_in_face(level_, cells_.corners_at(corners), edges, is_fine_);
  if (!part.level.refinement) {
    // Its regions are those of its edges' parts, joined along both sides of its arcs.
    for (const auto& [from, to] : part.level.arcs)
      for (const std::size_t k : {0U, 1U})
        part.joins.push_back({beside(part, from)[k], beside(part, to)[k]});
    return part;
  }
  // In a part of it, an edge between points of one side does not meet the level.
  const Refinement& r = *part.level.refinement;
  part.first = new_nodes(r.points().size());
  for (const Refinement::Cell& cell : r.cells()) {
    if (cell.cut) continue;
    for_subsets(3, 2, [&](const auto& m) {
      const Id p = cell.points[m[0]], q = cell.points[m[1]];
      if (r.points()[p].above == r.points()[q].above)
        part.joins.push_back({part.first + p, part.first + q});
    });
  }
  for_subsets(3, 2, [&](const auto& m) {
    std::size_t segment = edge(corners[m[0]], corners[m[1]]).first;
    bool above = is_above(corners[m[0]]);
    for (const Id p : points_along(r, static_cast<Id>(m[0]), static_cast<Id>(m[1]))) {
      if (r.points()[p].above != above) above = !above, ++segment;
      part.joins.push_back({part.first + p, segment});
    }
  });
  return part;
}

/// @param start  the first end of the edge
Sides Regions::beside(const EdgePart& part, Id start, std::size_t crossing) const {
  const std::size_t before = part.first + crossing;
  return is_above(start) == (crossing % 2 == 0) ? Sides{before + 1, before}
                                                : Sides{before, before + 1};
}

Sides Regions::beside(const FacePart& part, const Crossing& crossing) {
  const Id a = part.corners[crossing.edge[0]], b = part.corners[crossing.edge[1]];
  return beside(edge(a, b), a, crossing.ordinal);
}

/// Joins the regions on the boundary of a cell, and notes the pieces of the level in it.
///
/// On a sphere two regions have one closed curve between them, so the curves are those pairs.
/// If there are several, regions may be joined inside the cell; curves with the same regions at
/// both sides then bound one piece.
bool Regions::add_cell(const Refinement::Cell& cell) {
  Corners corners = cell.points;
  std::sort(corners.begin(), corners.end());
  SparseUnionFind around;
  const auto join = [&](const Join& nodes) {
    around.join(nodes[0], nodes[1]);
    all_.join(nodes[0], nodes[1]);
  };
  bool decided = true;
  std::vector<Sides> crossings;
  for_subsets(4, 2, [&](const auto& m) {
    const EdgePart& part = edge(corners[m[0]], corners[m[1]]);
    decided = decided && part.level.decided;
    for (const Join& nodes : part.joins) join(nodes);
    for (std::size_t k = 0; k < part.level.crossings; ++k)
      crossings.push_back(beside(part, corners[m[0]], k));
  });
  for (std::size_t f = 0; f < 4 && decided; ++f) {
    const FacePart& part = face(without(corners, f));
    decided = part.level.decided;
    for (const Join& nodes : part.joins) join(nodes);
    for (const auto& curve : part.level.loops) crossings.push_back(beside_curve(part, curve));
  }
  if (!decided) return false;
  std::map<Sides, Sides> curves;
  for (const Sides& s : crossings) curves.emplace(sides_in(around, s), s);
  if (curves.size() > 1 && !join_along(*cell.direction, corners, around, join)) return false;
  std::map<Sides, Piece> pieces;
  std::set<std::size_t> components;
  for (const auto& [key, s] : curves) {
    const Sides beside = sides_in(around, s);
    --pieces.try_emplace(beside, Piece{s, 2}).first->second.euler_characteristic;
    components.insert(beside.begin(), beside.end());
  }
  for (const auto& [key, piece] : pieces) pieces_.push_back(piece);
  // The components are joined like a tree by the pieces between them.
  return pieces.empty() || components.size() == pieces.size() + 1;
}

/// Along the direction of a monotone cell each point above can be moved to the upper part of the
/// boundary, from where the direction leaves the cell, and stays above: so the points above fall into
/// the components that are seen in the upper part, and a region that lies below that part belongs
/// to where any of its points comes out. The same holds for points below and the lower part.
bool Regions::join_along(const Refinement::Weights& direction, const Corners& corners,
                         SparseUnionFind& around, const auto& join) {
  std::array<Place<4>, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = cells_.points()[corners[i]].weights;
  const Place<4> upwards = weights_at(rows, direction);
  struct Moving {
    Place<4> place;
    bool above = false;
    std::size_t node = 0;
  };
  std::vector<Moving> all(4);
  for (std::size_t i = 0; i < 4; ++i)
    all[i].place[i] = 1, all[i].above = is_above(corners[i]), all[i].node = corners[i];
  for (std::size_t f = 0; f < 4; ++f) {
    const FacePart& part = face(without(corners, f));
    for (Id p = 0; part.level.refinement && p < part.level.refinement->points().size(); ++p) {
      const auto& point = part.level.refinement->points()[p];
      Moving& m = all.emplace_back(Moving{{}, point.above, part.first + p});
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != f) m.place[i] = point.weights[n++];
    }
  }
  const auto speed = [&](bool up, auto i) { return up ? mpz_class(-upwards[i]) : upwards[i]; };
  std::set<std::size_t> arrived, at_edges;
  for_subsets(4, 2, [&](const auto& members) {
    const EdgePart& part = edge(corners[members[0]], corners[members[1]]);
    for (std::size_t k = 0; k <= part.level.crossings; ++k) {
      const bool above = is_above(corners[members[0]]) == (k % 2 == 0);
      at_edges.insert(around.find(part.first + k));
      for (std::size_t i = 0; i < 4; ++i)
        if (i != members[0] && i != members[1] && speed(above, i) >= 0)
          arrived.insert(around.find(part.first + k));
    }
  });
  for (const Moving& m : all)
    for (std::size_t i = 0; i < 4; ++i)
      if (m.place[i] == 0 && speed(m.above, i) >= 0) arrived.insert(around.find(m.node));
  std::vector<Join> joins;
  for (const Moving& m : all) {
    if (!arrived.insert(around.find(m.node)).second) continue;
    std::size_t out = 4;
    for (std::size_t i = 0; i < 4; ++i)
      if (speed(m.above, i) > 0 &&
          (out == 4 || m.place[i] * speed(m.above, out) < m.place[out] * speed(m.above, i)))
        out = i;
    if (out == 4) return false;
    Place<4> exit;
    for (std::size_t i = 0; i < 4; ++i)
      exit[i] = m.place[i] * speed(m.above, out) - m.place[out] * speed(m.above, i);
    const auto node = find(face(without(corners, out)), without(exit, out), m.above);
    if (!node) return false;
    joins.push_back({m.node, *node});
  }
  // In faces that are not cut only their corners are known places.
  if (!std::includes(arrived.begin(), arrived.end(), at_edges.begin(), at_edges.end())) return false;
  for (const Join& nodes : joins) join(nodes);
  return true;
}

/// The region of a face's part at a place of it, by weights of its corners.
std::optional<std::size_t> Regions::find(const FacePart& part, const Place<3>& place,
                                         bool above) const {
  if (!part.level.refinement) {
    for (const Id corner : part.corners)
      if (is_above(corner) == above && part.level.arcs.size() < 2) return corner;
    return std::nullopt;
  }
  const auto& points = part.level.refinement->points();
  for (const Refinement::Cell& cell : part.level.refinement->cells()) {
    if (cell.cut) continue;
    std::array<Place<3>, 3> tile;
    for (std::size_t i = 0; i < 3; ++i) tile[i] = without(points[cell.points[i]].weights, 3);
    if (!is_inside(weights_at(tile, place))) continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (points[cell.points[i]].above == above) return part.first + cell.points[i];
  }
  return std::nullopt;
}

/// The region at a place of a face of the tetrahedron.
std::optional<std::size_t> Regions::find(std::size_t opposite, const Place<3>& place, bool above) {
  for (const Refinement::Cell& cell : cells_.cells()) {
    if (cell.cut) continue;
    Corners corners = cell.points;
    std::sort(corners.begin(), corners.end());
    for (std::size_t f = 0; f < 4; ++f) {
      const auto ids = without(corners, f);
      unsigned support = 0;
      std::array<Place<3>, 3> tile;
      for (std::size_t i = 0; i < 3; ++i) {
        support |= cells_.points()[ids[i]].support;
        tile[i] = without(cells_.points()[ids[i]].weights, opposite);
      }
      if ((support >> opposite & 1U) != 0) continue;
      const Place<3> inside = weights_at(tile, place);
      if (!is_inside(inside)) continue;
      if (cell.proof != Proof::empty) return find(face(ids), inside, above);
      return is_above(ids[0]) == above ? std::optional<std::size_t>(ids[0]) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// The crossings along the edges between roots, part by part.
bool Regions::number_crossings() {
  std::size_t which = 0;
  bool same = true;
  for_subsets(4, 2, [&](const auto& m) {
    std::vector<Sides>& all = on_roots_[1U << m[0] | 1U << m[1]];
    const auto along = points_along(cells_, static_cast<Id>(m[0]), static_cast<Id>(m[1]));
    for (std::size_t i = 0; same && i + 1 < along.size(); ++i) {
      const Id a = std::min(along[i], along[i + 1]), b = std::max(along[i], along[i + 1]);
      const EdgePart& part = edge(a, b);
      same = same && part.level.decided;
      for (std::size_t n = part.level.crossings, k = 0; k < n; ++k)
        all.push_back(beside(part, a, a == along[i] ? k : n - 1 - k));
    }
    same = same && all.size() == boundary_.edges[which++]->crossings;
  });
  return same;
}

std::optional<Sides> Regions::sides_of(const RimCurve& curve) {
  if (std::popcount(curve.simplex) == 2) return on_roots_.at(curve.simplex).at(curve.number);
  const auto opposite = static_cast<std::size_t>(std::countr_zero(15U & ~curve.simplex));
  const FaceLevel& level = *boundary_.faces[opposite];
  Sides result{};
  for (const Id id : level.loops.at(curve.number)[0]) {
    const auto& point = level.refinement->points()[id];
    const auto node = find(opposite, without(point.weights, 3), point.above);
    if (!node) return std::nullopt;
    result[point.above ? 1 : 0] = *node;
  }
  return result;
}

std::optional<std::vector<Sheet>> Regions::sheets(const std::vector<RimCurve>& curves) {
  new_nodes(cells_.points().size());
  if (!number_crossings()) return std::nullopt;
  for (const Refinement::Cell& cell : cells_.cells()) {
    if (cell.cut) continue;
    if (cell.proof != Proof::empty) {
      if (!add_cell(cell)) return std::nullopt;
    } else {
      for (std::size_t i = 1; i < 4; ++i) all_.join(cell.points[0], cell.points[i]);
    }
  }
  std::map<Sides, Sheet> found;
  const auto at = [&](const Sides& s) -> Sheet& { return found[sides_in(all_, s)]; };
  for (const auto& [key, part] : edges_) {
    const Id start = static_cast<Id>(part.joins[0][0]);
    for (std::size_t k = 0; k < part.level.crossings; ++k)
      ++at(beside(part, start, k)).euler_characteristic;
  }
  for (auto& [key, part] : faces_)
    for (const auto& arc : part.level.arcs) --at(beside(part, arc[0])).euler_characteristic;
  for (const Piece& piece : pieces_)
    at(piece.sides).euler_characteristic += piece.euler_characteristic;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto sides = sides_of(curves[i]);
    if (!sides) return std::nullopt;
    at(*sides).loops.push_back(i);
  }
  // Sheets join regions like a tree; beyond a closed one is what is farther from the corners' region.
  std::map<std::size_t, std::size_t> depth{{all_.find(0), 0}};
  for (bool more = true; std::exchange(more, false);)
    for (const auto& [sides, sheet] : found)
      for (const std::size_t k : {0U, 1U})
        if (depth.contains(sides[k]) &&
            depth.try_emplace(sides[1 - k], depth[sides[k]] + 1).second)
          more = true;
  for (auto& [sides, sheet] : found) sheet.above_inside = depth[sides[1]] > depth[sides[0]];
  std::vector<Sheet> result;
  for (auto& [sides, sheet] : found) result.push_back(std::move(sheet));
  return result;
}

}  // namespace

std::optional<std::vector<Sheet>> level_in_tet(const Level& level,
                                               const std::array<Corner, 4>& corners,
                                               const Proved<4>& proved,
                                               const TetBoundary& boundary,
                                               const std::vector<RimCurve>& curves) {
  // Each piece of a monotone tetrahedron has a boundary curve, and one curve bounds a disc.
  if (proved.proof == Proof::monotone && curves.size() < 2)
    return std::vector<Sheet>(curves.size(), Sheet{1, {0}, false});
  Refinement cells(level, corners);
  cells.assume(proved);
  if (!cells.run()) return std::nullopt;
  auto sheets = Regions(level, cells, boundary, false).sheets(curves);
  return sheets ? sheets : Regions(level, cells, boundary, true).sheets(curves);
}

}  // namespace certificate
