// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/pieces.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "run/parallel.hpp"

namespace certificate {

void Pieces::group() {
  const std::size_t count = mesh_.triangles().size();
  tets_.resize(count);
  parallel_for(count, [&](std::size_t t) {
    tets_[t] = c_.input.tet_at(c_.surface.cells[c_.triangles.first + t]);
  });
  if (const auto none = std::find(tets_.begin(), tets_.end(), Input::kNone); none != tets_.end())
    throw Wrong("a triangle in cell " +
                std::to_string(c_.surface.cells[c_.triangles.first +
                                                static_cast<Number>(none - tets_.begin())]) +
                ", no tetrahedron");
  by_tet_.resize(count);
  std::iota(by_tet_.begin(), by_tet_.end(), std::size_t{0});
  std::stable_sort(by_tet_.begin(), by_tet_.end(),
                   [&](std::size_t s, std::size_t t) { return tets_[s] < tets_[t]; });
  for (std::size_t n = 0; n < count; ++n)
    if (held_.empty() || held_.back() != tets_[by_tet_[n]])
      held_.push_back(tets_[by_tet_[n]]), first_.push_back(n);
  first_.push_back(count);

  const auto add = [&](std::size_t tet) {
    for (std::size_t i = 0; i < 4; ++i) tets_at_.emplace_back(without(c_.input.tets[tet], i), tet);
  };
  for (const TetTopology& tet : c_.topology.tets) add(tet.tet);
  for (const ConeTopology& cone : c_.topology.cones)
    if (cone.is_crossed() || !cone.is_decided()) add(cone.tet);
  for (std::size_t t = 0; t < c_.left_out.size(); ++t)
    if (c_.left_out[t]) add(t);
  std::sort(tets_at_.begin(), tets_at_.end());
}

/// Those of the level in a tetrahedron, ascending.
std::span<const std::size_t> Pieces::triangles_in(std::size_t tet) const {
  const auto place = std::lower_bound(held_.begin(), held_.end(), tet);
  if (place == held_.end() || *place != tet) return {};
  const std::size_t first = first_[static_cast<std::size_t>(place - held_.begin())],
                    end = first_[static_cast<std::size_t>(place - held_.begin()) + 1];
  return std::span(by_tet_).subspan(first, end - first);
}

std::span<const std::pair<Pieces::Face, std::size_t>> Pieces::tets_at(const Face& face) const {
  const auto begin =
      std::lower_bound(tets_at_.begin(), tets_at_.end(), std::pair(face, std::size_t{0}));
  auto end = begin;
  while (end != tets_at_.end() && end->first == face) ++end;
  return {begin, end};
}

/// Notes where the mesh runs along a curve of a face, and with whom it shares that.
void Pieces::add_chain(std::size_t tet, const Json& opposite, std::span<const BoundaryEdge> edges,
                       bool closed, Found& found) const {
  const auto& vertices = c_.input.tets[tet];
  const auto i = std::find(vertices.begin(), vertices.end(), opposite.get<Number>());
  if (i == vertices.end())
    throw Wrong("a loop through the face opposite vertex " + opposite.dump() +
                ", which is no corner");
  const Face face = without(vertices, static_cast<std::size_t>(i - vertices.begin()));
  std::size_t neighbour = kNone;
  for (const auto& [same, other] : tets_at(face))
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
  found.chains.push_back({face, tet, std::move(chain)});
}

/// A loop of triangles against a claimed one, which starts where it does. Returns it if it is a
/// closed curve of a face.
std::vector<ClosedLoop> Pieces::compare(std::size_t tet, const Json& claim,
                                        std::vector<BoundaryEdge>& loop, Found& found) const {
  const auto is_end_of = [&](const BoundaryEdge& e) { return is_end(e.from); };
  const auto ends = static_cast<std::size_t>(std::count_if(loop.begin(), loop.end(), is_end_of));
  if (claim.size() != 2 * std::max<std::size_t>(ends, 1))
    throw Wrong(std::to_string(ends) + " crossings on the loop through vertex " +
                std::to_string(loop.front().from) + ", claimed " + claim.dump());
  if (ends == 0) {
    add_chain(tet, claim[1], loop, true, found);
    ClosedLoop curve{claim[1].get<Vertex>(), {}};
    for (const BoundaryEdge& edge : loop) curve.vertices.push_back(edge.from);
    const Number least = *std::min_element(curve.vertices.begin(), curve.vertices.end());
    if (curve.vertices[0] != least)
      throw Wrong("a closed curve named by vertex " + std::to_string(curve.vertices[0]) +
                  ", the smallest is " + std::to_string(least));
    found.closed_curves.push_back(curve);
    return {curve};
  }
  auto start = loop.begin();
  for (std::size_t k = 0; k < ends; ++k) {
    if (claim[2 * k] != start->from)
      throw Wrong("crossing " + std::to_string(start->from) + " on a loop, where " +
                  claim[2 * k].dump() + " is claimed");
    const auto end = std::find_if(start + 1, loop.end(), is_end_of);
    if (!claim[2 * k + 1].is_null()) {
      add_chain(tet, claim[2 * k + 1], {start, end}, false, found);
    } else {
      found.folds.emplace_back(claim[0].get<Number>(), std::vector<BoundaryEdge>(start, end));
    }
    start = end;
  }
  return {};
}

/// The pieces of a tetrahedron against its claimed sheets, loop by loop.
void Pieces::compare(std::size_t tet, const Json& claim, std::vector<Piece>& pieces,
                     Found& found) const {
  struct Place {
    Number vertex;
    std::size_t piece, loop;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> at;  // of each boundary vertex; where it is twice, the first counts
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (std::size_t l = 0; l < pieces[p].loops.size(); ++l)
      for (const BoundaryEdge& edge : pieces[p].loops[l]) at.push_back({edge.from, p, l});
  std::sort(at.begin(), at.end());
  for (std::size_t n = 1; n < at.size(); ++n)
    if (at[n].vertex == at[n - 1].vertex && !apexes_.contains(at[n].vertex))
      throw Wrong("two pieces at vertex " + std::to_string(at[n].vertex));
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
      const Number vertex = claim[s][l][0].get<Number>();
      const auto place = std::lower_bound(at.begin(), at.end(), Place{vertex, 0, 0});
      if (place == at.end() || place->vertex != vertex)
        throw Wrong("a loop through vertex " + claim[s][l][0].dump() +
                    ", on the boundary of no piece");
      const auto [p, number] = std::pair(place->piece, place->loop);
      if (piece.value_or(p) != p || !loops.insert(number).second)
        throw Wrong("the loop through vertex " + claim[s][l][0].dump() + " bounds another piece");
      piece = p;
      std::vector<BoundaryEdge>& loop = pieces[p].loops[number];
      std::rotate(loop.begin(),
                  std::find_if(loop.begin(), loop.end(),
                               [&](const BoundaryEdge& e) { return e.from == vertex; }),
                  loop.end());
      for (ClosedLoop& curve : compare(tet, claim[s][l], loop, found))
        closed.push_back(std::move(curve));
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
    if (closed.size() == loops.size()) found.closed_sheets.push_back(std::move(closed));
  }
  for (Piece& piece : pieces)
    if (piece.loops.empty())
      found.closed_pieces.push_back({piece.euler_characteristic, std::move(piece.members)});
}

/// Two tetrahedra have the same curves on the face between them.
void Pieces::compare_chains() const {
  for (auto begin = chains_.begin(), end = begin; begin != chains_.end(); begin = end) {
    const Face& face = begin->face;
    while (end != chains_.end() && end->face == face) ++end;
    std::vector<std::vector<Chain>> both;
    for (const auto& [same, tet] : tets_at(face)) {
      if (c_.left_out[tet]) continue;
      std::vector<Chain>& chains = both.emplace_back();
      for (auto chain = begin; chain != end; ++chain)
        if (chain->tet == tet) chains.push_back(chain->chain);
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
void Pieces::compare_sheets(const Json& claim, const ConeTopology* cone, Found& found) const {
  const std::size_t tet = c_.input.tet_at(claim[0].get<Number>());
  const std::span triangles = triangles_in(tet);
  if (triangles.empty() || c_.left_out[tet]) throw Wrong("no triangles");
  std::vector<Piece> pieces = mesh_.pieces(
      triangles, [&](std::size_t t, std::size_t i, std::size_t other) {
        const auto& corners = mesh_.triangles()[t];
        return tets_[other] == tet &&
               !(apexes_.contains(corners[i]) && apexes_.contains(corners[(i + 1) % 3]));
      });
  if (cone == nullptr) return compare(tet, claim, pieces, found);
  compare(tet, with_loops(c_, vertices_, *cone, claim), pieces, found);
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

/// Keeps what was found in a tetrahedron.
void Pieces::take(std::size_t tet, Found&& found) {
  std::move(found.chains.begin(), found.chains.end(), std::back_inserter(chains_));
  for (auto& [crossing, edges] : found.folds) {
    auto& fold = folds_[{tet, crossing}];
    fold.insert(fold.end(), edges.begin(), edges.end());
  }
  for (auto& sheet : found.closed_sheets) closed_sheets_.emplace_back(tet, std::move(sheet));
  for (ClosedLoop& curve : found.closed_curves) closed_curves_.emplace_back(tet, std::move(curve));
  for (ClosedPiece& piece : found.closed_pieces) closed_pieces_[tet].push_back(std::move(piece));
}

/// Returns of how many tetrahedra the claims are.
std::size_t Pieces::compare_all(const Json& claims, bool are_cones) {
  std::vector<Found> all(claims.size());
  parallel_for(all.size(), [&](std::size_t n) {
    const Json& claim = claims[n];
    const ConeTopology* cone = c_.topology.cone(c_.input.tet_at(claim[0].get<Number>()));
    try {
      if ((cone != nullptr) != are_cones) throw Wrong("no such sheets");
      compare_sheets(claim, cone, all[n]);
    } catch (const Wrong& wrong) {
      all[n].wrong = wrong.what() + (" in tetrahedron " + claim[0].dump());
    }
  });
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (!all[n].wrong.empty()) throw Wrong(all[n].wrong);
    take(c_.input.tet_at(claims[n][0].get<Number>()), std::move(all[n]));
  }
  return all.size();
}

void Pieces::compare() {
  group();
  note_apexes();
  std::size_t matched = compare_all(c_.claims["tets"], false);
  matched += compare_all(c_.claims["cones"], true);
  std::stable_sort(chains_.begin(), chains_.end(), [](const FaceChain& a, const FaceChain& b) {
    return std::tie(a.face, a.tet) < std::tie(b.face, b.tet);
  });
  for (const std::size_t tet : held_)
    if (c_.left_out[tet]) ++matched;
  if (matched != held_.size()) {
    std::set<std::size_t> claimed;
    for (const char* list : {"tets", "cones"})
      for (const Json& claim : c_.claims[list]) claimed.insert(c_.input.tet_at(claim[0].get<Number>()));
    for (const std::size_t tet : held_)
      if (!c_.left_out[tet] && !claimed.contains(tet))
        throw Wrong("triangle " + std::to_string(c_.triangles.first + triangles_in(tet)[0]) +
                    " in tetrahedron " + std::to_string(c_.input.cells[tet]) + " without sheets");
    throw Wrong("sheets of a tetrahedron claimed twice");
  }
  compare_chains();
  compare_folds();
  compare_fans();
}

/// In which simplices the vertices must lie but for crossings.
void Pieces::note_places(PlacedSurface& result) const {
  const std::size_t first = c_.vertices.first;
  const auto same = [](const Carrier& a, const Carrier& b) {
    return a.count == b.count && a.corners == b.corners;
  };
  for (std::size_t v = 0; v < result.carriers.size(); ++v)
    if (!vertices_.crossing.contains(first + v)) result.places.push_back({first + v, result.carriers[v]});
  for (const auto& [face, tet, chain] : chains_)
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
                       std::move(closed_pieces_), {}, {}};
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
  for (const auto& [face, tet, chain] : chains_)
    if (tets_at(face).size() == 1) result.border.push_back({face, chain, !is_end(chain[0])});
  for (const auto& [face, tet, chain] : chains_)
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
