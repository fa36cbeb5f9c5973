// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/pieces.hpp"

#include <algorithm>

namespace certificate {

void Pieces::group() {
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    const Number cell = c_.surface.cells[c_.triangles.first + t];
    tets_.push_back(c_.input.tet_at(cell));
    if (tets_.back() == Input::kNone)
      throw Wrong("a triangle in cell " + std::to_string(cell) + ", no tetrahedron");
    by_tet_[tets_.back()].push_back(t);
  }
  const auto add = [&](std::size_t tet) {
    for (std::size_t i = 0; i < 4; ++i) tets_at_[face_of(c_.input.tets[tet], i)].push_back(tet);
  };
  for (const TetTopology& tet : c_.topology.tets) add(tet.tet);
  for (const ConeTopology& cone : c_.topology.cones)
    if (cone.is_crossed() || !cone.is_decided()) add(cone.tet);
  for (std::size_t t = 0; t < c_.left_out.size(); ++t)
    if (c_.left_out[t]) add(t);
  for (const auto& [face, tets] : tets_at_)
    if (tets.size() > 2) throw Wrong("a face of three tetrahedra " + Json(face).dump());
}

/// Notes where the mesh runs along a curve of a face, and with whom it shares that.
void Pieces::add_chain(std::size_t tet, const Json& opposite, std::span<const BoundaryEdge> edges,
                       bool closed) {
  const auto& vertices = c_.input.tets[tet];
  const auto i = std::find(vertices.begin(), vertices.end(), opposite.get<Number>());
  if (i == vertices.end())
    throw Wrong("a loop through the face opposite vertex " + opposite.dump() +
                ", which is no corner");
  const Face face = face_of(vertices, static_cast<std::size_t>(i - vertices.begin()));
  std::size_t neighbour = kNone;
  for (const std::size_t other : tets_at_[face])
    if (other != tet) neighbour = other;
  const bool may_end = neighbour == kNone || c_.left_out[neighbour];
  Chain chain;
  for (const BoundaryEdge& edge : edges) {
    chain.push_back(edge.from);
    const std::size_t there = edge.across == kNone ? kNone : tets_[edge.across];
    if (there != neighbour && !(there == kNone && may_end))
      throw Wrong("an edge at vertex " + std::to_string(edge.to) + " not shared through face " +
          Json(face).dump());
  }
  if (!closed) chain.push_back(edges.back().to);
  chains_[face][tet].push_back(std::move(chain));
}

/// A loop of triangles against a claimed one, which starts where it does. Returns it if it is a
/// closed curve of a face.
std::vector<ClosedLoop> Pieces::compare(std::size_t tet, const Json& claim,
                                        std::vector<BoundaryEdge>& loop) {
  const auto is_end_of = [&](const BoundaryEdge& e) { return is_end(e.from); };
  const auto ends = static_cast<std::size_t>(std::count_if(loop.begin(), loop.end(), is_end_of));
  if (claim.size() != 2 * std::max<std::size_t>(ends, 1))
    throw Wrong(std::to_string(ends) + " crossings on the loop through vertex " +
                std::to_string(loop.front().from) + ", claimed " + claim.dump());
  if (ends == 0) {
    add_chain(tet, claim[1], loop, true);
    ClosedLoop found{claim[1].get<Vertex>(), {}};
    for (const BoundaryEdge& edge : loop) found.vertices.push_back(edge.from);
    if (found.vertices[0] != *std::min_element(found.vertices.begin(), found.vertices.end()))
      throw Wrong("a closed curve named by vertex " + std::to_string(found.vertices[0]) +
                  ", the smallest is " + std::to_string(*std::min_element(found.vertices.begin(),
                                                                     found.vertices.end())));
    closed_curves_.emplace_back(tet, found);
    return {found};
  }
  auto start = loop.begin();
  for (std::size_t k = 0; k < ends; ++k) {
    if (claim[2 * k] != start->from)
      throw Wrong("crossing " + std::to_string(start->from) + " on a loop, where " +
                  claim[2 * k].dump() + " is claimed");
    const auto end = std::find_if(start + 1, loop.end(), is_end_of);
    if (!claim[2 * k + 1].is_null()) {
      add_chain(tet, claim[2 * k + 1], {start, end}, false);
    } else {
      auto& fold = folds_[{tet, claim[0].get<Number>()}];
      fold.insert(fold.end(), start, end);
    }
    start = end;
  }
  return {};
}

/// The pieces of a tetrahedron against its claimed sheets, loop by loop.
void Pieces::compare(std::size_t tet, const Json& claim, std::vector<Piece>& pieces) {
  std::map<Number, std::pair<std::size_t, std::size_t>>
      at;  // of each boundary vertex: piece and loop
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (std::size_t l = 0; l < pieces[p].loops.size(); ++l)
      for (const BoundaryEdge& edge : pieces[p].loops[l])
        if (!at.try_emplace(edge.from, p, l).second && !apexes_.contains(edge.from))
          throw Wrong("two pieces at vertex " + std::to_string(edge.from));
  std::vector<bool> is_used(pieces.size());
  if (pieces.size() != claim.size() - 1)
    throw Wrong(std::to_string(pieces.size()) + " pieces of triangles, " +
                std::to_string(claim.size() - 1) + " claimed");
  for (std::size_t s = 1; s < claim.size(); ++s) {
    std::vector<ClosedLoop> closed;
    std::optional<std::size_t> piece;
    std::set<std::size_t> loops;
    for (std::size_t p = 0; p < pieces.size() && claim[s].size() == 1; ++p)
      if (pieces[p].loops.empty() && !is_used[p]) piece = p;
    for (std::size_t l = 1; l < claim[s].size(); ++l) {
      const auto place = at.find(claim[s][l][0].get<Number>());
      if (place == at.end())
        throw Wrong("a loop through vertex " + claim[s][l][0].dump() +
                    ", on the boundary of no piece");
      const auto [p, number] = place->second;
      if (piece.value_or(p) != p || !loops.insert(number).second)
        throw Wrong("the loop through vertex " + claim[s][l][0].dump() + " bounds another piece");
      piece = p;
      std::vector<BoundaryEdge>& loop = pieces[p].loops[number];
      std::rotate(loop.begin(),
                  std::find_if(loop.begin(), loop.end(),
                               [&](const BoundaryEdge& e) { return e.from == place->first; }),
                  loop.end());
      for (ClosedLoop& curve : compare(tet, claim[s][l], loop)) closed.push_back(std::move(curve));
    }
    if (!piece || is_used[*piece])
      throw Wrong("no piece for the sheet " + claim[s].dump());
    if (loops.size() != pieces[*piece].loops.size() ||
        claim[s][0] != pieces[*piece].euler_characteristic)
      throw Wrong("the piece with vertex " + std::to_string(pieces[*piece].vertices[0]) +
                  " has Euler characteristic " +
                  std::to_string(pieces[*piece].euler_characteristic) + " and " +
                  std::to_string(pieces[*piece].loops.size()) + " loops, claimed " +
                  claim[s].dump());
    is_used[*piece] = true;
    if (closed.size() == loops.size()) closed_sheets_.emplace_back(tet, std::move(closed));
  }
  for (Piece& piece : pieces)
    if (piece.loops.empty())
      closed_pieces_[tet].push_back({piece.euler_characteristic, std::move(piece.members)});
}

/// Two tetrahedra have the same curves on the face between them.
void Pieces::compare_chains() const {
  for (const auto& [face, sides] : chains_) {
    std::vector<std::vector<Chain>> both;
    for (const std::size_t tet : tets_at_.at(face)) {
      if (c_.left_out[tet]) continue;
      const auto side = sides.find(tet);
      std::vector<Chain>& chains = both.emplace_back();
      if (side != sides.end()) chains = side->second;
      if (both.size() == 2) {
        for (Chain& chain : chains) {
          const bool closed = !is_end(chain[0]);
          std::reverse(chain.begin() + (closed ? 1 : 0), chain.end());
        }
      }
      std::sort(chains.begin(), chains.end());
    }
    if (both.size() == 2 && both[0] != both[1])
      throw Wrong("two sides of face " + Json(face).dump() + " differ: " + Json(both[0]).dump() +
                  " and " + Json(both[1]).dump());
  }
}

void Pieces::note_apexes() {
  for (const Json& claim : c_.claims["cones"])
    for (std::size_t i = 1; i < claim.size(); ++i)
      for (std::size_t k = claim[i].size() == 3 ? 2 : 1; k < claim[i].size(); ++k)
        if (vertices_.crossing.contains(*apexes_.insert(claim[i][k].get<Number>()).first))
          throw Wrong("a crossing as tip, vertex " + claim[i][k].dump());
}

/// @param cone  if it is one
void Pieces::compare_sheets(const Json& claim, const ConeTopology* cone) {
  const std::size_t tet = c_.input.tet_at(claim[0].get<Number>());
  const auto triangles = by_tet_.find(tet);
  if (triangles == by_tet_.end() || c_.left_out[tet]) throw Wrong("no triangles");
  std::vector<Piece> pieces = mesh_.pieces(
      triangles->second, [&](std::size_t t, std::size_t i, std::size_t other) {
        const auto& corners = mesh_.triangles()[t];
        return tets_[other] == tet &&
               !(apexes_.contains(corners[i]) && apexes_.contains(corners[(i + 1) % 3]));
      });
  if (cone == nullptr) return compare(tet, claim, pieces);
  compare(tet, with_loops(c_, vertices_, *cone, claim), pieces);
  for (std::size_t i = 1; i < claim.size(); ++i) {
    const auto holds = [&](const Piece& piece) {
      const auto has = [&](const Json& v) {
        return std::binary_search(piece.vertices.begin(), piece.vertices.end(), v.get<Number>());
      };
      return has(claim[i][0]) && has(claim[i].back());
    };
    if (std::none_of(pieces.begin(), pieces.end(), holds))
      throw Wrong("vertices " + claim[i][0].dump() + " and " + claim[i].back().dump() +
                  ", a crossing and a tip, in different pieces");
  }
}

void Pieces::compare() {
  group();
  note_apexes();
  std::size_t matched = 0;
  const auto compare_all = [&](const Json& claims, bool are_cones) {
    for (const Json& claim : claims) {
      const ConeTopology* cone = c_.topology.cone(c_.input.tet_at(claim[0].get<Number>()));
      try {
        if ((cone != nullptr) != are_cones) throw Wrong("no such sheets");
        compare_sheets(claim, cone);
      } catch (const Wrong& wrong) {
        throw Wrong(wrong.what() + (" in tetrahedron " + claim[0].dump()));
      }
      ++matched;
    }
  };
  compare_all(c_.claims["tets"], false);
  compare_all(c_.claims["cones"], true);
  for (const auto& [tet, triangles] : by_tet_)
    if (c_.left_out[tet]) ++matched;
  if (matched != by_tet_.size()) {
    std::set<std::size_t> claimed;
    for (const char* list : {"tets", "cones"})
      for (const Json& claim : c_.claims[list]) claimed.insert(c_.input.tet_at(claim[0].get<Number>()));
    for (const auto& [tet, triangles] : by_tet_)
      if (!c_.left_out[tet] && !claimed.contains(tet))
        throw Wrong("triangle " + std::to_string(c_.triangles.first + triangles[0]) +
                    " in tetrahedron " + std::to_string(c_.input.cells[tet]) + " without sheets");
    throw Wrong("sheets of a tetrahedron claimed twice");
  }
  compare_chains();
  compare_folds();
  compare_fans();
}

/// Sheets that a stretch of larger modes around an edge between tips has at its ends are joined
/// there, and no others.
void Pieces::compare_folds() const {
  const Folds folds(c_);
  const auto edges_of = [&](const Fold& fold) -> const std::vector<BoundaryEdge>& {
    const auto name = vertices_.vertex.find(fold.cone->sheets[fold.sheet].crossings[0]);
    if (name != vertices_.vertex.end())
      if (const auto found = folds_.find({fold.cone->tet, name->second}); found != folds_.end())
        return found->second;
    throw Wrong("no sheet at the crossing in tetrahedron " +
                std::to_string(c_.input.cells[fold.cone->tet]));
  };
  for (const ConeTopology& cone : c_.topology.cones) {
    if (!cone.is_decided()) continue;
    for (std::size_t k = 0; cone.tips.size() == 2 && k < cone.sheets.size(); ++k) {
      const std::vector<BoundaryEdge>& own = edges_of({&cone, k});
      Face last{};
      const Fold other = folds.beyond({&cone, k}, last);
      bool same = true;
      if (other.cone != nullptr && !other.cone->is_decided()) continue;
      if (other.cone != nullptr) {
        const std::vector<BoundaryEdge>& there = edges_of(other);
        same = std::equal(own.begin(), own.end(), there.rbegin(), there.rend(),
                          [](const BoundaryEdge& a, const BoundaryEdge& b) {
                            return a.from == b.to && a.to == b.from;
                          });
      } else {
        std::sort(last.begin(), last.end());
        const auto tets = tets_at_.find(last);
        for (const std::size_t tet : tets == tets_at_.end() ? std::vector<std::size_t>{}
                                                            : tets->second)
          if (c_.left_out[tet]) same = false;
        // What is left out may be joined to anything, or nothing.
        same = !same || std::all_of(own.begin(), own.end(),
                                    [](const BoundaryEdge& e) { return e.across == kNone; });
      }
      if (!same) throw Wrong("sheets joined otherwise in tetrahedron " +
                             std::to_string(c_.input.cells[cone.tet]));
    }
  }
}

/// Around an edge of the mesh tetrahedra that are not left out fall into groups that are joined
/// through faces. All triangles of a group that have a crossing of that edge have one vertex for
/// it; and each vertex that the certificate gives a crossing is that of a group.
void Pieces::compare_fans() const {
  if (vertices_.original.empty()) return;
  std::map<MeshCrossing, std::map<std::size_t, Number>> used;  // by tetrahedra
  std::set<Number> seen;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (c_.left_out[tets_[t]]) continue;
    for (const std::uint32_t v : c_.surface.triangles[c_.triangles.first + t]) {
      const auto crossing = vertices_.crossing.find(v);
      if (crossing == vertices_.crossing.end()) continue;
      const auto& tet = c_.input.tets[tets_[t]];
      for (const Vertex end : crossing->second.edge)
        if (std::find(tet.begin(), tet.end(), end) == tet.end())
          throw Wrong("vertex " + std::to_string(v) + ", a crossing's, beside another edge");
      if (used[crossing->second].emplace(tets_[t], v).first->second != v)
        throw Wrong("two vertices of a crossing in one tetrahedron, one of them " +
                    std::to_string(v));
      seen.insert(v);
    }
  }
  for (const auto& [v, crossing] : vertices_.crossing)
    if (!seen.contains(v))
      throw Wrong("vertex " + std::to_string(v) + " of a crossing is that of no triangles there");
  for (const auto& [crossing, by_tet] : used)
    for (const auto& [tet, v] : by_tet)
      for (std::size_t i = 0; i < 4; ++i) {
        const Vertex opposite = c_.input.tets[tet][i];
        if (opposite == crossing.edge[0] || opposite == crossing.edge[1]) continue;
        for (const std::size_t other : tets_at_.at(face_of(c_.input.tets[tet], i)))
          if (const auto there = by_tet.find(other); there != by_tet.end() && there->second != v)
            throw Wrong("vertices " + std::to_string(v) + " and " + std::to_string(there->second) +
                        " of a crossing beside one face of the mesh");
      }
}

/// In which simplices the vertices must lie but for crossings.
void Pieces::note_places(PlacedSurface& result) const {
  const std::size_t first = c_.vertices.first;
  const auto same = [](const Carrier& a, const Carrier& b) {
    return a.count == b.count && a.corners == b.corners;
  };
  for (std::size_t v = 0; v < result.carriers.size(); ++v)
    if (!vertices_.crossing.contains(first + v)) result.places.push_back({first + v, result.carriers[v]});
  for (const auto& [face, sides] : chains_)
    for (const auto& [tet, chains] : sides)
      for (const Chain& chain : chains)
        for (const Number v : chain) {
          const Carrier carrier{{face[0], face[1], face[2]}, 3};
          if (!is_end(v) && !same(result.carriers[v - first], carrier))
            result.places.push_back({v, carrier});
        }
  std::set<std::pair<Number, std::size_t>> inside;
  for (std::size_t t = 0; t < result.tets.size(); ++t)
    for (const Number v : c_.surface.triangles[c_.triangles.first + t])
      if (c_.left_out[result.tets[t]] && inside.emplace(v, result.tets[t]).second)
        result.places.push_back({v, {c_.input.tets[result.tets[t]], 4}});
}

/// A vertex that is on no edge or face is inside the tetrahedron of its triangles.
PlacedSurface Pieces::place() && {
  const std::size_t first = c_.vertices.first;
  PlacedSurface result{std::vector<Carrier>(c_.vertices.count), std::move(tets_),
                       std::move(closed_sheets_), std::move(closed_curves_),
                       std::move(closed_pieces_), {}};
  for (const auto& [vertex, crossing] : vertices_.crossing)
    result.carriers[vertex - first] = {{crossing.edge[0], crossing.edge[1]}, 2};
  for (const Json& claim : c_.claims["cones"]) {
    const ConeTopology& cone = *c_.topology.cone(c_.input.tet_at(claim[0].get<Number>()));
    for (std::size_t i = 1; i < claim.size(); ++i) {
      const auto carrier = [&](std::size_t k) -> Carrier& {
        return result.carriers[claim[i][k].get<Number>() - first];
      };
      if (claim[i].size() < 4) {
        carrier(claim[i].size() - 1) = {{cone.tips[0]}, 1};
        continue;
      }
      for (const std::size_t k : {1u, 3u})
        carrier(k) = {{cone.tips[is_at(c_, claim[i][k], cone.tips[0]) ? 0 : 1]}, 1};
      carrier(2) = {{cone.tips[0], cone.tips[1]}, 2};
    }
  }
  for (const auto& [face, sides] : chains_)
    for (const auto& [tet, chains] : sides)
      for (const Chain& chain : chains)
        for (const Number v : chain)
          if (Carrier& carrier = result.carriers[v - first]; carrier.count == 0)
            carrier = {{face[0], face[1], face[2]}, 3};
  for (std::size_t t = 0; t < result.tets.size(); ++t)
    for (const Number v : mesh_.triangles()[t])
      if (Carrier& carrier = result.carriers[v - first]; carrier.count == 0)
        carrier = {c_.input.tets[result.tets[t]], 4};
  note_places(result);
  return result;
}

}  // namespace certificate
