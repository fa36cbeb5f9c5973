// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_surface.hpp"

#include <algorithm>

#include "half_edges.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using Chain = std::vector<Number>;  ///< vertices along an arc, or around a closed curve
using Face = std::array<Vertex, 3>;
constexpr std::size_t kNone = HalfEdges::kNone;

/// A boundary edge of the triangles in one tetrahedron.
struct Rim {
  std::uint32_t to;
  std::size_t triangle, neighbour_tet;  ///< of the triangle across; kNone if there is none
};

class Pieces {
 public:
  Pieces(const LevelCase& c, const CrossingVertices& vertices, const std::vector<bool>& left_out,
         const HalfEdges& mesh)
      : c_(c), vertices_(vertices), left_out_(left_out), mesh_(mesh) {}

  /// What is wrong, if anything.
  std::string defect();
  PlacedSurface place() &&;

 private:
  struct Piece {
    long euler_characteristic = 0;
    std::vector<std::vector<Rim>> loops;
  };
  std::size_t tet_of(std::size_t triangle) const {
    const std::size_t first = c_.claims.triangles[0];
    const auto& cells = c_.input.cells;
    const auto place =
        std::lower_bound(cells.begin(), cells.end(), c_.surface.cells[first + triangle]);
    const bool found = place != cells.end() && *place == c_.surface.cells[first + triangle];
    return found ? static_cast<std::size_t>(place - cells.begin()) : kNone;
  }
  std::string group();
  std::string collect(std::size_t tet, const std::vector<std::size_t>& triangles,
                      std::vector<Piece>& pieces) const;
  std::string compare(std::size_t tet, const TetClaim& claim, std::vector<Piece>& pieces);
  std::string add_chain(std::size_t tet, Vertex opposite, const std::vector<Rim>& chain,
                        std::uint32_t start, bool closed);
  std::string compare_chains() const;

  const LevelCase& c_;
  const CrossingVertices& vertices_;
  const std::vector<bool>& left_out_;
  const HalfEdges& mesh_;
  std::vector<std::size_t> tets_;  ///< of each triangle
  std::map<std::size_t, std::vector<std::size_t>> by_tet_;
  std::map<Face, std::vector<std::size_t>> tets_at_;  ///< that are crossed or left out
  std::map<Face, std::map<std::size_t, std::vector<Chain>>> chains_;
  std::vector<std::pair<std::size_t, std::vector<ClosedLoop>>> closed_sheets_;
};

std::string at(std::size_t cell) { return " in tetrahedron " + std::to_string(cell); }

std::string Pieces::group() {
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    tets_.push_back(tet_of(t));
    if (tets_.back() == kNone) return "a triangle in cell " +
        std::to_string(c_.surface.cells[c_.claims.triangles[0] + t]) + ", no tetrahedron";
    by_tet_[tets_.back()].push_back(t);
  }
  const auto add = [&](std::size_t tet) {
    for (std::size_t i = 0; i < 4; ++i) tets_at_[face_of(c_.input.tets[tet], i)].push_back(tet);
  };
  for (const TetTopology& tet : c_.topology.tets) add(tet.tet);
  for (std::size_t t = 0; t < left_out_.size(); ++t)
    if (left_out_[t]) add(t);
  for (const auto& [face, tets] : tets_at_)
    if (tets.size() > 2) return "a face of three tetrahedra " + text(face);
  return {};
}

/// The connected pieces of the triangles in one tetrahedron.
std::string Pieces::collect(std::size_t tet, const std::vector<std::size_t>& triangles,
                            std::vector<Piece>& pieces) const {
  UnionFind joined(triangles.size());
  std::map<std::uint32_t, Rim> rim;
  std::map<std::uint32_t, std::size_t> piece_of;  // of each vertex, by one of its triangles
  std::map<std::size_t, Piece> found;
  std::vector<long> edges(triangles.size());
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    const std::size_t t = triangles[n];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& corners = mesh_.triangles()[t];
      piece_of.emplace(corners[i], n);
      const std::size_t other = mesh_.across(t, i);
      if (other != kNone && tets_[other] == tet) {
        const auto place = std::lower_bound(triangles.begin(), triangles.end(), other);
        joined.join(n, static_cast<std::size_t>(place - triangles.begin()));
        if (other > t) ++edges[n];
        continue;
      }
      ++edges[n];
      const Rim edge{corners[(i + 1) % 3], t, other == kNone ? kNone : tets_[other]};
      if (!rim.emplace(corners[i], edge).second)
        return "the rim passes vertex " + std::to_string(corners[i]) + " twice" +
               at(c_.input.cells[tet]);
    }
  }
  for (std::size_t n = 0; n < triangles.size(); ++n)
    found[joined.find(n)].euler_characteristic += 1 - edges[n];
  for (const auto& [v, n] : piece_of) ++found[joined.find(n)].euler_characteristic;
  while (!rim.empty()) {
    const std::uint32_t start = rim.begin()->first;
    std::vector<Rim> loop{{start, 0, 0}};
    const std::size_t piece = joined.find(piece_of[start]);
    for (std::uint32_t v = start;;) {
      const auto place = rim.find(v);
      if (place == rim.end()) return "a rim that does not close" + at(c_.input.cells[tet]);
      loop.push_back(place->second);
      v = place->second.to;
      rim.erase(place);
      if (v == start) break;
    }
    loop.erase(loop.begin());
    found[piece].loops.push_back(std::move(loop));
  }
  for (auto& [n, piece] : found) pieces.push_back(std::move(piece));
  return {};
}

/// Notes where the mesh runs along a curve of a face, and with whom it shares that.
std::string Pieces::add_chain(std::size_t tet, Vertex opposite, const std::vector<Rim>& chain,
                              std::uint32_t start, bool closed) {
  const auto& vertices = c_.input.tets[tet];
  const auto i = std::find(vertices.begin(), vertices.end(), opposite) - vertices.begin();
  if (i == 4) return "a loop through no face" + at(c_.input.cells[tet]);
  const Face face = face_of(vertices, static_cast<std::size_t>(i));
  std::size_t neighbour = kNone;
  for (const std::size_t other : tets_at_[face])
    if (other != tet) neighbour = other;
  const bool may_end = neighbour == kNone || left_out_[neighbour];
  Chain numbers;
  if (!closed) numbers.push_back(start);
  for (const Rim& edge : chain) {
    numbers.push_back(edge.to);
    if (edge.neighbour_tet != neighbour && !(edge.neighbour_tet == kNone && may_end))
      return "an edge at vertex " + std::to_string(edge.to) + " not shared through face " +
             text(face);
  }
  if (closed)
    std::rotate(numbers.begin(), std::min_element(numbers.begin(), numbers.end()), numbers.end());
  chains_[face][tet].push_back(std::move(numbers));
  return {};
}

/// The pieces of a tetrahedron against its claimed sheets, loop by loop.
std::string Pieces::compare(std::size_t tet, const TetClaim& claim, std::vector<Piece>& pieces) {
  const std::string where = at(claim.tet);
  // A loop is turned to start at its smallest crossing, or vertex if it has none.
  const auto smallest = [&](const std::vector<Rim>& loop) {
    Number best = ~Number{0}, any = ~Number{0};
    for (const Rim& edge : loop) {
      any = std::min<Number>(any, edge.to);
      if (vertices_.crossing.contains(edge.to)) best = std::min<Number>(best, edge.to);
    }
    return best == ~Number{0} ? any : best;
  };
  for (Piece& piece : pieces)
    std::sort(piece.loops.begin(), piece.loops.end(),
              [&](const auto& a, const auto& b) { return smallest(a) < smallest(b); });
  for (const Piece& piece : pieces)
    if (piece.loops.empty()) return "a piece without boundary" + where;
  std::sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return smallest(a.loops[0]) < smallest(b.loops[0]);
  });
  if (pieces.size() != claim.sheets.size())
    return std::to_string(pieces.size()) + " pieces of triangles" + where;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const SheetClaim& sheet = claim.sheets[p];
    if (pieces[p].euler_characteristic != sheet.euler_characteristic)
      return "a piece of Euler characteristic " +
             std::to_string(pieces[p].euler_characteristic) + where;
    std::vector<ClosedLoop> closed_loops;
    if (pieces[p].loops.size() != sheet.loops.size())
      return "a piece with " + std::to_string(pieces[p].loops.size()) + " loops" + where;
    for (std::size_t l = 0; l < sheet.loops.size(); ++l) {
      const std::vector<Number>& claimed = sheet.loops[l];
      std::vector<Rim>& loop = pieces[p].loops[l];
      const Number first = smallest(loop);
      if (first != claimed[0]) return "a loop from vertex " + std::to_string(first) + where;
      std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), [&](const Rim& e) {
        return e.to == first; }) + 1, loop.end());  // so that it ends there
      const bool closed = !vertices_.crossing.contains(first);
      std::vector<Rim> chain;
      std::size_t k = 0;
      Number start = first;
      for (const Rim& edge : loop) {
        chain.push_back(edge);
        const bool ends = closed ? edge.to == first : vertices_.crossing.contains(edge.to);
        if (!ends) continue;
        if (k >= claimed.size() || claimed[k] != start) return "other crossings on a loop" + where;
        const std::string wrong =
            add_chain(tet, static_cast<Vertex>(std::min<Number>(claimed[k + 1], ~Vertex{0})), chain,
                      static_cast<std::uint32_t>(start), closed);
        if (!wrong.empty()) return wrong;
        if (closed) {
          ClosedLoop& found = closed_loops.emplace_back(static_cast<Vertex>(claimed[1]), Chain{});
          for (const Rim& passed : chain) found.vertices.push_back(passed.to);
        }
        start = edge.to, k += 2;
        chain.clear();
      }
      if (k != claimed.size()) return "fewer crossings on a loop" + where;
    }
    if (closed_loops.size() == sheet.loops.size())
      closed_sheets_.emplace_back(tet, std::move(closed_loops));
  }
  return {};
}

/// Two tetrahedra have the same curves on the face between them.
std::string Pieces::compare_chains() const {
  for (const auto& [face, sides] : chains_) {
    std::vector<std::vector<Chain>> both;
    for (const std::size_t tet : tets_at_.at(face)) {
      if (left_out_[tet]) continue;
      const auto side = sides.find(tet);
      std::vector<Chain>& chains = both.emplace_back();
      if (side != sides.end()) chains = side->second;
      if (both.size() == 2) {
        for (Chain& chain : chains) {
          const bool closed = chain.size() > 1 && !vertices_.crossing.contains(chain[0]);
          std::reverse(chain.begin() + (closed ? 1 : 0), chain.end());
        }
      }
      std::sort(chains.begin(), chains.end());
    }
    if (both.size() == 2 && both[0] != both[1])
      return "two sides of face " + text(face) + " differ";
  }
  return {};
}

/// A vertex that is on no edge or face is inside the tetrahedron of its triangles.
PlacedSurface Pieces::place() && {
  const std::size_t first = c_.claims.vertices[0];
  PlacedSurface result{std::vector<Carrier>(c_.claims.vertices[1]), std::move(tets_),
                       std::move(closed_sheets_)};
  for (const auto& [vertex, crossing] : vertices_.crossing)
    result.carriers[vertex - first] = {{crossing.edge[0], crossing.edge[1]}, 2};
  for (const auto& [face, sides] : chains_)
    for (const auto& [tet, chains] : sides)
      for (const Chain& chain : chains)
        for (const Number v : chain)
          if (Carrier& carrier = result.carriers[v - first]; carrier.count != 2)
            carrier = {{face[0], face[1], face[2]}, 3};
  for (std::size_t t = 0; t < result.tets.size(); ++t)
    for (const Number v : mesh_.triangles()[t])
      if (Carrier& carrier = result.carriers[v - first]; carrier.count == 0)
        carrier = {c_.input.tets[result.tets[t]], 4};
  return result;
}

std::string Pieces::defect() {
  if (std::string wrong = group(); !wrong.empty()) return wrong;
  std::map<std::size_t, const TetClaim*> claims;
  for (const TetClaim& claim : c_.claims.tets) {
    const auto place = std::lower_bound(c_.input.cells.begin(), c_.input.cells.end(), claim.tet);
    if (place == c_.input.cells.end() || *place != claim.tet)
      return "no tetrahedron " + std::to_string(claim.tet);
    claims[static_cast<std::size_t>(place - c_.input.cells.begin())] = &claim;
  }
  for (const auto& [tet, triangles] : by_tet_) {
    if (left_out_[tet]) continue;
    const auto claim = claims.find(tet);
    if (claim == claims.end()) return "triangles, but no sheets" + at(c_.input.cells[tet]);
    std::vector<Piece> pieces;
    std::string wrong = collect(tet, triangles, pieces);
    if (wrong.empty()) wrong = compare(tet, *claim->second, pieces);
    if (!wrong.empty()) return wrong;
    claims.erase(claim);
  }
  if (!claims.empty()) return "no triangles" + at(c_.input.cells[claims.begin()->first]);
  return compare_chains();
}

}  // namespace

std::optional<PlacedSurface> compare_surface(const LevelCase& c,
                                             const CrossingVertices& vertices,
                                             const std::vector<bool>& left_out, Ledger& ledger) {
  const auto [first, count] = c.claims.triangles;
  const std::span triangles = std::span(c.surface.triangles).subspan(first, count);
  std::vector<bool> used(c.claims.vertices[1]);
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      if (v - c.claims.vertices[0] >= used.size())
        return ledger.refute("triangles", "of this level",
                             "vertex " + std::to_string(v) + " of another"),
               std::nullopt;
      used[v - c.claims.vertices[0]] = true;
    }
  }
  if (std::find(used.begin(), used.end(), false) != used.end())
    return ledger.refute("triangles", "all vertices", "one is in no triangle"), std::nullopt;
  const HalfEdges mesh(triangles);
  std::string defect = mesh.defect();
  Pieces pieces(c, vertices, left_out, mesh);
  if (defect.empty()) defect = pieces.defect();
  ledger.settle(defect.empty(), "triangles", "pieces as in the tetrahedra's sheets", defect);

  const std::vector<ComponentClaim> derived = mesh.components();
  const auto describe = [](const ComponentClaim& p) {
    return "Euler characteristic " + std::to_string(p.euler_characteristic) + ", " +
           std::to_string(p.boundary_loops) + " loops, " + (p.orientable ? "" : "not ") +
           "orientable, " + std::to_string(p.triangles) + " triangles from vertex " +
           std::to_string(p.first_vertex);
  };
  for (std::size_t i = 0; i < std::max(derived.size(), c.claims.components.size()); ++i) {
    const bool has_claim = i < c.claims.components.size(), has_truth = i < derived.size();
    ledger.settle(has_claim && has_truth && c.claims.components[i] == derived[i],
                  "component " + std::to_string(i),
                  has_claim ? describe(c.claims.components[i]) : "none",
                  has_truth ? describe(derived[i]) : "none");
  }
  return defect.empty() ? std::optional(std::move(pieces).place()) : std::nullopt;
}

}  // namespace certificate
