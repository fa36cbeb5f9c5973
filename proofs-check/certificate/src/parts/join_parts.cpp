// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/join_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "claims/half_edges.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

std::string place_text(const BorderPlace& place) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.17g %.17g %.17g)", place[0], place[1], place[2]);
  return text;
}

/// A face as one of the parts has it.
struct FaceOfPart {
  std::array<BorderPlace, 3> places{};
  std::size_t part = 0;
  std::uint32_t face = 0;

  auto operator<=>(const FaceOfPart&) const = default;
};

class Seams {
 public:
  Seams(const std::vector<PartBorder>& borders, Ledger& ledger)
      : borders_(borders), ledger_(ledger) {
    std::size_t count = 0;
    for (const PartBorder& border : borders) {
      first_component_.push_back(count);
      count += border.components.size();
      is_glued_.emplace_back(border.edges.size());
      auto& order = by_face_.emplace_back(border.edges.size());
      for (std::size_t e = 0; e < order.size(); ++e) order[e] = e;
      std::sort(order.begin(), order.end(), [&](std::size_t d, std::size_t e) {
        return key(border.edges[d]) < key(border.edges[e]);
      });
    }
    glued_.resize(count);
  }

  /// False if something is refuted or open.
  bool glue() {
    const std::size_t open = ledger_.open();
    compare_points();
    std::vector<FaceOfPart> faces;
    for (std::size_t p = 0; p < borders_.size(); ++p)
      for (std::uint32_t f = 0; f < borders_[p].faces.size(); ++f) {
        const auto& points = borders_[p].faces[f].points;
        const auto& all = borders_[p].points;
        faces.push_back({{all[points[0]].place, all[points[1]].place, all[points[2]].place}, p, f});
      }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
      while (end < faces.size() && faces[end].places == faces[i].places) ++end;
      if (faces[i].part == faces[end - 1].part) continue;  // of one part, which may be torn
      compare(std::span(faces).subspan(i, end - i));
    }
    return !ledger_.has_refuted() && ledger_.open() == open;
  }

  JoinedSurface surface();
  /// What the array `whole_component` says; after `surface`.
  /// @return whether it was found right
  bool compare_numbers(std::size_t count);

 private:
  static std::pair<std::uint32_t, std::array<SurfaceEnd, 2>> key(const SurfaceEdge& edge) {
    return {edge.face, edge.ends};
  }
  std::size_t vertex(std::size_t part, std::uint32_t v) { return part << 32 | v; }
  std::size_t component(std::size_t part, const SurfaceEdge& edge) {
    return classes_.find(first_component_[part] + edge.component);
  }

  /// Points of different parts at one place have one tensor.
  void compare_points() {
    struct PointOfPart {
      BorderPlace place;
      std::size_t part, point;
      auto operator<=>(const PointOfPart&) const = default;
    };
    std::vector<PointOfPart> all;
    for (std::size_t p = 0; p < borders_.size(); ++p)
      for (std::size_t i = 0; i < borders_[p].points.size(); ++i)
        all.push_back({borders_[p].points[i].place, p, i});
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0, first = 0, end = 0; i < all.size(); ++i) {
      if (i == end) {
        first = i;
        while (end < all.size() && all[end].place == all[first].place) ++end;
      }
      const auto &a = all[first], &b = all[i];
      if (a.part == all[end - 1].part ||
          borders_[a.part].points[a.point].tensor == borders_[b.part].points[b.point].tensor)
        continue;
      ledger_.refute("point " + place_text(a.place), "one tensor",
                     "different tensors in parts " + std::to_string(a.part) + " and " +
                         std::to_string(b.part));
    }
  }

  std::span<const std::size_t> edges_on(const FaceOfPart& f) const {
    const auto& edges = borders_[f.part].edges;
    const auto& order = by_face_[f.part];
    const auto begin =
        std::lower_bound(order.begin(), order.end(), f.face,
                         [&](std::size_t e, std::uint32_t face) { return edges[e].face < face; });
    const auto end =
        std::upper_bound(order.begin(), order.end(), f.face,
                         [&](std::uint32_t face, std::size_t e) { return face < edges[e].face; });
    return {begin, end};
  }

  /// Why edges on a face may not be told apart by their places; null if they can be. By the places of
  /// different vertices arcs cannot be exchanged, and one closed curve is no other.
  const char* doubt_on(const FaceOfPart& f) const {
    const auto& edges = borders_[f.part].edges;
    std::map<BorderPlace, std::uint32_t> known;
    std::map<std::uint32_t, std::size_t> number;
    for (const std::size_t e : edges_on(f))
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::uint32_t v = edges[e].vertices[end];
        if (known.try_emplace(edges[e].ends[end].place, v).first->second != v)
          return "two vertices at one place";
        number.try_emplace(v, number.size());
      }
    UnionFind chains;  // of the face
    std::set<std::size_t> closed;
    for (const std::size_t e : edges_on(f))
      chains.join(number[edges[e].vertices[0]], number[edges[e].vertices[1]]);
    for (const auto& [v, n] : number) closed.insert(chains.find(n));
    for (const std::size_t e : edges_on(f))
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
        if (edges[e].ends[end].crossing != 0)
          closed.erase(chains.find(number[edges[e].vertices[end]]));
    return closed.size() > 1 ? "several closed curves" : nullptr;
  }

  /// One face of several parts.
  void compare(std::span<const FaceOfPart> same) {
    std::string name = "face " + place_text(same[0].places[0]) + ' ' +
                       place_text(same[0].places[1]) + ' ' + place_text(same[0].places[2]) +
                       " of parts";
    for (const FaceOfPart& f : same) name += ' ' + std::to_string(f.part);
    if (same.size() > 2)
      return ledger_.refute(name, "two tetrahedra", std::to_string(same.size()) + " tetrahedra");
    const FaceOfPart &a = same[0], &b = same[1];
    if (borders_[a.part].faces[a.face].side == borders_[b.part].faces[b.face].side)
      return ledger_.refute(name, "a tetrahedron on each side", "both on the same side");
    const auto &edges = borders_[a.part].edges, &others = borders_[b.part].edges;
    const auto here = edges_on(a), there = edges_on(b);
    std::vector<std::pair<std::array<SurfaceEnd, 2>, std::size_t>> back;  // turned around
    for (const std::size_t e : there) back.push_back({{others[e].ends[1], others[e].ends[0]}, e});
    std::sort(back.begin(), back.end());
    for (std::size_t k = 0; k < std::max(here.size(), back.size()); ++k) {
      const bool is_here =
          k == back.size() || (k < here.size() && edges[here[k]].ends < back[k].first);
      const bool is_there =
          k == here.size() || (k < back.size() && back[k].first < edges[here[k]].ends);
      if (!is_here && !is_there) continue;
      const auto& ends = is_here ? edges[here[k]].ends : back[k].first;
      return ledger_.refute(name, "the same edges of triangles on both sides",
                            "the edge " + place_text(ends[0].place) + ' ' +
                                place_text(ends[1].place) + " in part " +
                                std::to_string(is_here ? a.part : b.part) + " only");
    }
    for (std::size_t k = 1; k < here.size(); ++k)
      if (edges[here[k]].ends == edges[here[k - 1]].ends)
        return ledger_.leave_open(name, "two edges of triangles at one place");
    for (const FaceOfPart& f : same)
      if (const char* doubt = doubt_on(f)) return ledger_.leave_open(name, doubt);
    ledger_.certify();
    for (std::size_t k = 0; k < here.size(); ++k) {
      const SurfaceEdge &e = edges[here[k]], &f = others[back[k].second];
      is_glued_[a.part][here[k]] = is_glued_[b.part][back[k].second] = true;
      classes_.join(component(a.part, e), component(b.part, f));
      ++glued_[first_component_[a.part] + e.component];
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::size_t u = vertex(a.part, e.vertices[end]),
                          v = vertex(b.part, f.vertices[1 - end]);
        vertices_.join(u, v);
        members_[u] = first_component_[a.part] + e.component;
        members_[v] = first_component_[b.part] + f.component;
      }
    }
  }

  const std::vector<PartBorder>& borders_;
  Ledger& ledger_;
  std::vector<std::size_t> first_component_;       ///< of each part, among those of all
  std::vector<std::vector<std::size_t>> by_face_;  ///< edges of each part
  std::vector<std::vector<bool>> is_glued_;        ///< of each part's edges
  UnionFind classes_;                              ///< of components
  SparseUnionFind vertices_;                       ///< of glued vertices
  std::map<std::size_t, std::size_t> members_;     ///< the component of each glued vertex
  std::vector<std::size_t> glued_;                 ///< pairs of edges, by component of the first
  std::vector<std::size_t> number_;                ///< of each part's component, in the whole
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
    for (std::size_t e = 0; e < borders_[p].edges.size(); ++e) {
      if (is_glued_[p][e]) continue;
      const SurfaceEdge& edge = borders_[p].edges[e];
      const std::size_t from = name(p, edge.vertices[0]), to = name(p, edge.vertices[1]);
      if (!next.try_emplace(from, to, number_[first_component_[p] + edge.component]).second)
        throw Wrong("the boundary passes " + place_text(edge.ends[0].place) + " twice");
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

bool Seams::compare_numbers(std::size_t count) {
  std::map<std::size_t, double> said;
  std::set<double> all;
  std::size_t i = 0, silent = 0;
  const auto wrong = [&](std::size_t part, const std::string& what) {
    ledger_.refute("whole_component",
                   "the components of the whole, each with a number of its own from 0",
                   what + " in part " + std::to_string(part));
    return false;
  };
  for (std::size_t p = 0; p < borders_.size(); ++p)
    for (const PartComponent& part : borders_[p].components) {
      const std::size_t number = number_[i++];
      if (!part.whole) {
        ++silent;
        continue;
      }
      if (!part.whole_is_one) return wrong(p, "several numbers on one component");
      const auto [known, is_new] = said.try_emplace(number, *part.whole);
      if (known->second != *part.whole) return wrong(p, "another number for the same component");
      if (is_new && !all.insert(*part.whole).second)
        return wrong(p, "the number of another component");
      if (!(*part.whole >= 0 && *part.whole < static_cast<double>(count)) ||
          *part.whole != std::floor(*part.whole))
        return wrong(p, "what is no number of a component");
    }
  if (silent == i) return false;  // nothing is claimed
  if (silent > 0) return wrong(0, "no array, though other parts have one, or none");
  ledger_.certify();
  return true;
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
