// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/part_border.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "claims/curve_names.hpp"
#include "claims/curve_numbers.hpp"
#include "places.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Directed edges of triangles.
struct DirectedEdgeHash {
  std::size_t operator()(const DirectedEdge& s) const {
    return (std::uint64_t{s.first} << 32 | s.second) * 0x9e3779b97f4a7c15U >> 7;
  }
};

/// The level's components, and which one each of its vertices is in.
std::vector<std::uint32_t> count_components(const LevelCase& c,
                                            const std::vector<DirectedEdge>& border,
                                            PartBorder& result) {
  const auto& triangles = c.surface.triangles;
  UnionFind classes;
  for (const auto& t : triangles) classes.join(t[0], t[1]), classes.join(t[0], t[2]);
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> component(c.surface.points.size(), kNone);
  std::vector<std::uint32_t> number(c.surface.points.size(), kNone);
  const Array* whole = nullptr;
  for (const Array& array : c.surface.arrays)
    if (array.name == "whole_component" && array.of == "triangles" && array.components == 1)
      whole = &array;
    else if (array.name == "whole_component")
      result.whole_is_elsewhere = true;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::uint32_t& known = number[classes.find(triangles[t][0])];
    if (known == kNone) {
      known = static_cast<std::uint32_t>(result.components.size());
      result.components.emplace_back();
      if (whole != nullptr) result.components.back().said.whole = whole->numbers[t];
    }
    PartComponent& own = result.components[known];
    ++own.triangles;
    if (whole != nullptr) own.said.hear(whole->numbers[t]);
    for (const std::uint32_t v : triangles[t]) {
      if (component[v] == kNone) ++own.vertices;
      component[v] = known;
    }
  }
  std::vector<std::size_t> sides(result.components.size());
  for (const DirectedEdge& side : border) ++sides[component[side.first]];
  for (std::size_t i = 0; i < sides.size(); ++i)
    result.components[i].edges = (3 * result.components[i].triangles + sides[i]) / 2;
  return component;
}

}  // namespace

void add_surface(const LevelCase& c, const CrossingVertices& vertices, const PlacedSurface& placed,
                 PartBorder& border) {
  const auto original = [&](std::uint32_t v) {
    const auto copy = vertices.original.find(v);
    return copy == vertices.original.end() ? v : static_cast<std::uint32_t>(copy->second);
  };
  std::unordered_map<DirectedEdge, char, DirectedEdgeHash> directed;
  for (const auto& t : c.surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) directed.try_emplace({t[i], t[(i + 1) % 3]}, 0);
  std::vector<DirectedEdge> outer;
  std::map<DirectedEdge, DirectedEdge>
      named;  // edges of one triangle, by the names that chains have for them
  for (const auto& t : c.surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const DirectedEdge side{t[i], t[(i + 1) % 3]};
      if (directed.contains({side.second, side.first})) continue;
      outer.push_back(side);
      named[{original(side.first), original(side.second)}] = side;
    }
  const std::vector<std::uint32_t> component = count_components(c, outer, border);

  std::map<std::array<Vertex, 2>, std::uint32_t> crossings;  // of an edge, how many
  for (const auto& [vertex, crossing] : vertices.crossing) {
    auto& count = crossings[crossing.edge];
    count = std::max(count, crossing.ordinal + 1);
  }
  const auto end_of = [&](Number v) -> ChainEnd {
    const auto crossing = vertices.crossing.find(v);
    if (crossing == vertices.crossing.end()) return {};
    const auto& [edge, ordinal] = crossing->second;
    const BorderPlace from = place_of(c.input.points[edge[0]]),
                      to = place_of(c.input.points[edge[1]]);
    return {from < to ? ordinal + 1 : crossings[edge] - ordinal,
            {std::min(from, to), std::max(from, to)}};
  };
  std::map<FaceCorners, std::vector<std::size_t>> numbers;  // of closed curves
  const auto number_of =
      [&](const PlacedSurface::BorderChain& chain) -> std::optional<std::size_t> {
    const FaceTopology* const face = c.topology.face(chain.face);
    if (face == nullptr) return std::nullopt;  // claimed of a face that has none
    const std::vector<Number> names = curve_names(c, *face);
    const auto name = std::find(names.begin(), names.end(),
                                *std::min_element(chain.vertices.begin(), chain.vertices.end()));
    if (name == names.end()) return std::nullopt;
    const auto [known, is_new] = numbers.try_emplace(chain.face);
    if (is_new)
      known->second = names.size() > 1 ? curve_numbers(c, *face) : std::vector<std::size_t>{0};
    if (known->second.empty()) return std::nullopt;
    return known->second[static_cast<std::size_t>(name - names.begin())];
  };
  std::map<FaceCorners, std::uint32_t> number;
  const auto faces = outer_faces(c.input);
  for (std::size_t f = 0; f < faces.size(); ++f)
    number[faces[f].first] = static_cast<std::uint32_t>(f);
  std::size_t edges = 0;
  for (const PlacedSurface::BorderChain& chain : placed.border) {
    const auto at = number.find(chain.face);
    if (at == number.end()) continue;
    BorderChain own{at->second, {chain.closed, {}, {}}, {}, {}, 0};
    const auto add = [&](std::uint32_t v) {
      own.vertices.push_back(v);
      own.places.push_back(place_of(c.surface.points[v]));
    };
    const std::size_t count = chain.vertices.size();
    bool is_there = true;  // else it is no border
    for (std::size_t k = 0; k + (chain.closed ? 0 : 1) < count; ++k) {
      const auto side = named.find({static_cast<std::uint32_t>(chain.vertices[k]),
                                    static_cast<std::uint32_t>(chain.vertices[(k + 1) % count])});
      is_there = is_there && side != named.end();
      if (!is_there) break;
      add(side->second.first);
      if (!chain.closed && k + 2 == count) add(side->second.second);
    }
    if (!is_there) continue;
    own.component = component[own.vertices[0]];
    if (chain.closed)
      own.curve.number = number_of(chain);
    else
      own.curve.ends = {end_of(chain.vertices.front()), end_of(chain.vertices.back())};
    edges += own.edges();
    border.chains.push_back(std::move(own));
  }
  border.is_complete = edges == outer.size();
}

}  // namespace certificate
