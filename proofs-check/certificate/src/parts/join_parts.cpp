// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/join_parts.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "claims/half_edges.hpp"
#include "parts/glued_faces.hpp"
#include "parts/match_chains.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

constexpr const char* kWhich = "which closed curve is which";

class Seams {
 public:
  Seams(const std::vector<PartBorder>& borders, Ledger& ledger)
      : borders_(borders), ledger_(ledger) {
    std::size_t count = 0;
    for (const PartBorder& border : borders) {
      first_component_.push_back(count);
      count += border.components.size();
      is_glued_.emplace_back(border.chains.size());
      auto& order = by_face_.emplace_back(border.chains.size());
      for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
      std::stable_sort(order.begin(), order.end(), [&](std::size_t m, std::size_t n) {
        return border.chains[m].face < border.chains[n].face;
      });
    }
    glued_.resize(count);
  }

  /// False if something is refuted or open.
  bool glue() {
    const std::size_t open = ledger_.open();
    std::vector<const MeshBorder*> meshes;
    for (const PartBorder& border : borders_) meshes.push_back(&border);
    for (const GluedFace& face : glued_faces(meshes, ledger_)) compare(face);
    return !ledger_.has_refuted() && ledger_.open() == open;
  }

  JoinedSurface surface();
  /// See `compare_whole_numbers`; after `surface`.
  bool compare_numbers(std::size_t count) const {
    std::vector<std::vector<SaidNumber>> said;
    for (const PartBorder& border : borders_) {
      auto& own = said.emplace_back();
      for (const PartComponent& part : border.components) own.push_back(part.said);
    }
    return compare_whole_numbers(said, number_, count, ledger_);
  }

 private:
  std::size_t vertex(std::size_t part, std::uint32_t v) { return part << 32 | v; }
  std::size_t component(std::size_t part, const BorderChain& chain) const {
    return first_component_[part] + chain.component;
  }

  /// A chain of a face, and its curve as the part on the first side of the face has that.
  struct ChainOfFace {
    CurveOfFace curve;
    std::size_t chain = 0;
  };
  /// In the order of the curves.
  std::vector<ChainOfFace> chains_on(const FaceOfPart& f, bool turned) const {
    const auto& chains = borders_[f.part].chains;
    const auto& order = by_face_[f.part];
    auto next =
        std::lower_bound(order.begin(), order.end(), f.face,
                         [&](std::size_t n, std::uint32_t face) { return chains[n].face < face; });
    std::vector<ChainOfFace> result;
    for (; next != order.end() && chains[*next].face == f.face; ++next) {
      result.push_back({chains[*next].curve, *next});
      if (turned) std::swap(result.back().curve.ends[0], result.back().curve.ends[1]);
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const ChainOfFace& m, const ChainOfFace& n) { return m.curve < n.curve; });
    return result;
  }

  void compare(const GluedFace& face) {
    const FaceOfPart &a = face.one, &b = face.other;
    const std::string& name = face.name;
    const auto here = chains_on(a, false), there = chains_on(b, true);
    const auto of = [&](const FaceOfPart& f, const ChainOfFace& n) -> const BorderChain& {
      return borders_[f.part].chains[n.chain];
    };
    const auto is_unknown = [](const ChainOfFace& n) {
      return n.curve.is_closed && !n.curve.number;
    };
    if (std::any_of(here.begin(), here.end(), is_unknown) ||
        std::any_of(there.begin(), there.end(), is_unknown))
      return ledger_.leave_open(name, kWhich);
    for (std::size_t k = 0; k < std::max(here.size(), there.size()); ++k) {
      if (k < here.size() && k < there.size() && here[k].curve == there[k].curve) continue;
      const bool is_here = k == there.size() || (k < here.size() && here[k].curve < there[k].curve);
      return ledger_.refute(name, "the same curves on both sides",
                            "the curve through " +
                                place_text((is_here ? of(a, here[k]) : of(b, there[k])).places[0]) +
                                " in part " + std::to_string(is_here ? a.part : b.part) + " only");
    }
    std::vector<std::size_t> turns;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const BorderChain& chain = of(a, here[k]);
      const auto turn = turn_between(chain, of(b, there[k]));
      if (turn) {
        turns.push_back(*turn);
        continue;
      }
      // If another curve has these places, it may be that they do not tell which curve is whose.
      const auto has_places = [&](const ChainOfFace& n) {
        return n.curve.is_closed && turn_between(chain, of(b, n));
      };
      if (chain.curve.is_closed && std::any_of(there.begin(), there.end(), has_places))
        return ledger_.leave_open(name, kWhich);
      const std::size_t edge = first_difference(chain, of(b, there[k]));
      return ledger_.refute(name, "the same edges of triangles on both sides",
                            "the edge " + place_text(chain.places[edge]) + ' ' +
                                place_text(chain.places[(edge + 1) % chain.places.size()]) +
                                " in part " + std::to_string(a.part) + " only");
    }
    ledger_.certify();
    for (std::size_t k = 0; k < here.size(); ++k)
      glue({a.part, b.part}, {here[k].chain, there[k].chain}, turns[k]);
  }

  /// Chains of two parts, of which the vertices of the first are those of the second from `turn`
  /// on backwards.
  void glue(const std::array<std::size_t, 2>& parts, const std::array<std::size_t, 2>& chains,
            std::size_t turn) {
    const BorderChain &chain = borders_[parts[0]].chains[chains[0]],
                      &other = borders_[parts[1]].chains[chains[1]];
    const std::size_t one = component(parts[0], chain), two = component(parts[1], other);
    is_glued_[parts[0]][chains[0]] = is_glued_[parts[1]][chains[1]] = true;
    classes_.join(one, two);
    glued_[one] += chain.edges();
    const std::size_t count = chain.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t u = vertex(parts[0], chain.vertices[i]),
                        v = vertex(parts[1], other.vertices[(turn + count - i) % count]);
      vertices_.join(u, v);
      members_[u] = one, members_[v] = two;
    }
  }

  const std::vector<PartBorder>& borders_;
  Ledger& ledger_;
  std::vector<std::size_t> first_component_;       ///< of each part, among those of all
  std::vector<std::vector<std::size_t>> by_face_;  ///< chains of each part
  std::vector<std::vector<bool>> is_glued_;        ///< of each part's chains
  UnionFind classes_;                              ///< of components
  SparseUnionFind vertices_;                       ///< of glued vertices
  std::map<std::size_t, std::size_t> members_;     ///< the component of each glued vertex
  std::vector<std::size_t> glued_;   ///< pairs of edges, by component of the first part
  std::vector<std::size_t> number_;  ///< of each part's component, in the whole
};

JoinedSurface Seams::surface() {
  JoinedSurface whole;
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::size_t count = 0;
  for (const PartBorder& border : borders_) count += border.components.size();
  std::vector<std::size_t> of_class(count, kNone);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t& known = of_class[classes_.find(i)];
    if (known == kNone) known = whole.components.size(), whole.components.emplace_back();
    number_.push_back(known);
  }
  std::size_t i = 0;
  for (const PartBorder& border : borders_)
    for (const PartComponent& part : border.components) {
      Component& own = whole.components[number_[i]];
      own.euler_characteristic += static_cast<long>(part.vertices + part.triangles + glued_[i]) -
                                  static_cast<long>(part.edges);
      own.cells += part.triangles;
      whole.vertices += part.vertices, whole.triangles += part.triangles;
      ++i;
    }
  // Of the vertices that are one, all but one are counted once too often.
  std::set<std::size_t> seen;
  for (const auto& [v, part] : members_)
    if (!seen.insert(vertices_.find(v)).second)
      --whole.components[number_[part]].euler_characteristic, --whole.vertices;

  std::map<std::size_t, std::pair<std::size_t, std::size_t>> next;  // vertex and component
  std::map<std::size_t, std::size_t> free;  // vertices that are not glued, after the others
  const auto name = [&](std::size_t part, std::uint32_t v) {
    const std::size_t own = vertex(part, v);
    if (members_.contains(own)) return vertices_.find(own);
    return members_.size() + free.try_emplace(own, free.size()).first->second;
  };
  for (std::size_t p = 0; p < borders_.size(); ++p)
    for (std::size_t n = 0; n < borders_[p].chains.size(); ++n) {
      const BorderChain& chain = borders_[p].chains[n];
      const std::size_t length = chain.vertices.size();
      for (std::size_t k = 0; k < chain.edges() && !is_glued_[p][n]; ++k)
        if (!next.try_emplace(name(p, chain.vertices[k]), name(p, chain.vertices[(k + 1) % length]),
                              number_[component(p, chain)])
                 .second)
          throw Wrong("the boundary passes " + place_text(chain.places[k]) + " twice");
    }
  while (!next.empty()) {
    const auto start = next.begin()->first;
    ++whole.components[next.begin()->second.second].boundary_loops;
    for (auto at = next.begin(); at != next.end();) {
      const std::size_t to = at->second.first;
      next.erase(at);
      at = next.find(to);
      if (at == next.end() && to != start) throw Wrong("a boundary that does not close");
    }
  }
  for (const Component& own : whole.components) {
    whole.euler_characteristic += own.euler_characteristic;
    whole.boundary_loops += own.boundary_loops;
  }
  return whole;
}

}  // namespace

std::optional<JoinedSurface> join_parts(const std::vector<PartBorder>& borders, Ledger& ledger) {
  ledger.begin("seams");
  Seams seams(borders, ledger);
  if (!seams.glue()) return std::nullopt;
  JoinedSurface whole;
  try {
    whole = seams.surface();
  } catch (const Wrong& wrong) {
    return ledger.leave_open("boundary", wrong.what()), std::nullopt;
  }
  ledger.begin("arrays");
  whole.has_numbers = seams.compare_numbers(whole.components.size());
  return whole;
}

}  // namespace certificate
