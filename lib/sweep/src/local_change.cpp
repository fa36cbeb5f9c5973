// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/sweep/local_change.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tensortopo {
namespace {

using Edge = std::pair<int, int>;

/// The full subcomplex on some of a link's vertices.
struct Part {
  int components = 0;
  int euler_characteristic = 0;
  bool is_disc() const { return components == 1 && euler_characteristic == 1; }
};

int root_of(std::vector<int>& parent, int v) {
  while (parent[static_cast<std::size_t>(v)] != v) {
    int& up = parent[static_cast<std::size_t>(v)];
    v = up = parent[static_cast<std::size_t>(up)];
  }
  return v;
}

template <class Belongs>
Part part_of(const SignedLink& link, const std::map<Edge, int>& edges, const Belongs& belongs) {
  Part part;
  std::vector<int> parent(link.signs.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [edge, triangles] : edges) {
    if (!belongs(edge.first) || !belongs(edge.second)) continue;
    --part.euler_characteristic;
    parent[static_cast<std::size_t>(root_of(parent, edge.first))] = root_of(parent, edge.second);
  }
  for (const auto& t : link.triangles)
    if (std::all_of(t.begin(), t.end(), belongs)) ++part.euler_characteristic;
  for (int v = 0; v < static_cast<int>(parent.size()); ++v) {
    if (!belongs(v)) continue;
    ++part.euler_characteristic;
    part.components += root_of(parent, v) == v;
  }
  return part;
}

/// `below` pieces that meet in a point are replaced by `above` pieces.
GrowthBounds growth(int below, int above) {
  return {std::min(1, above) - below, above - std::min(1, below)};
}

}  // namespace

std::string_view name_of(LocalChange change) {
  switch (change) {
    case LocalChange::regular:
      return "regular";
    case LocalChange::birth:
      return "birth";
    case LocalChange::death:
      return "death";
    case LocalChange::join:
      return "join";
    case LocalChange::split:
      return "split";
    case LocalChange::open:
      return "open";
    case LocalChange::close:
      return "close";
    case LocalChange::other:
      return "other";
    case LocalChange::undecided:
      break;
  }
  return "undecided";
}

std::vector<std::vector<int>> parts_of_sign(const SignedLink& link, Verdict sign) {
  std::vector<int> parent(link.signs.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto belongs = [&](int v) { return link.signs[static_cast<std::size_t>(v)] == sign; };
  for (const auto& t : link.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [v, w] = std::minmax(t[i], t[(i + 1) % 3]);
      if (!belongs(v) || !belongs(w)) continue;
      const auto [first, second] = std::minmax({root_of(parent, v), root_of(parent, w)});
      parent[static_cast<std::size_t>(second)] = first;
    }
  std::map<int, std::vector<int>> parts;
  for (int v = 0; v < static_cast<int>(parent.size()); ++v)
    if (belongs(v)) parts[root_of(parent, v)].push_back(v);
  std::vector<std::vector<int>> result;
  for (auto& [root, part] : parts) result.push_back(std::move(part));
  return result;
}

std::vector<char> parts_on_boundary(const SignedLink& link,
                                    const std::vector<std::vector<int>>& parts) {
  std::map<Edge, int> edges;
  for (const auto& t : link.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  std::vector<char> is_outer(link.signs.size(), 0);
  for (const auto& [edge, triangles] : edges)
    if (triangles == 1)
      for (const int v : {edge.first, edge.second}) is_outer[static_cast<std::size_t>(v)] = 1;
  std::vector<char> result;
  for (const auto& part : parts)
    result.push_back(std::any_of(part.begin(), part.end(), [&](int v) {
      return is_outer[static_cast<std::size_t>(v)] != 0;
    }));
  return result;
}

LocalEffect local_effect(const SignedLink& link) {
  LocalEffect effect;
  std::map<Edge, int> edges;
  for (const auto& t : link.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  std::vector<int> ends(link.signs.size(), 0);  // of edges on the boundary
  int boundary_edges = 0, boundary_vertices = 0, sign_changes = 0;
  bool is_manifold = true;
  const auto sign = [&](int v) { return link.signs[static_cast<std::size_t>(v)]; };
  for (const auto& [edge, triangles] : edges) {
    is_manifold &= triangles <= 2;
    if (triangles != 1) continue;
    ++boundary_edges;
    for (const int v : {edge.first, edge.second})
      boundary_vertices += ends[static_cast<std::size_t>(v)]++ == 0;
    sign_changes += sign(edge.first) != sign(edge.second);
  }
  effect.on_boundary = boundary_edges > 0;
  // A connected surface with the Euler characteristic of a sphere or of a disc is one, if as many
  // vertices as edges are on its boundary, two edges at each.
  const Part whole = part_of(link, edges, [](int) { return true; });
  is_manifold &= whole.components == 1 && boundary_edges == boundary_vertices &&
                 whole.euler_characteristic == (effect.on_boundary ? 1 : 2) &&
                 std::all_of(ends.begin(), ends.end(), [](int n) { return n == 0 || n == 2; });
  const auto is_strict = [](Verdict v) { return v == Verdict::positive || v == Verdict::negative; };
  if (!is_manifold || !std::all_of(link.signs.begin(), link.signs.end(), is_strict)) return effect;

  const Part below = part_of(link, edges, [&](int v) { return sign(v) == Verdict::negative; });
  const Part above = part_of(link, edges, [&](int v) { return sign(v) == Verdict::positive; });
  effect.euler_change = above.euler_characteristic - below.euler_characteristic;
  effect.components = growth(below.components, above.components);
  if (effect.on_boundary) {
    // On the circle of the link's boundary as many arcs are of one sign as of the other, or it is
    // all of one.
    const auto end = std::find_if(ends.begin(), ends.end(), [](int n) { return n != 0; });
    const bool is_above = sign(static_cast<int>(end - ends.begin())) == Verdict::positive;
    const int arcs = sign_changes / 2;
    effect.boundary_loops = arcs > 0 ? growth(arcs, arcs) : growth(!is_above, is_above);
  }
  if (below.is_disc() && above.is_disc() && (!effect.on_boundary || sign_changes == 2))
    effect.change = LocalChange::regular;
  else if (below.components == 0)
    effect.change = LocalChange::birth;
  else if (above.components == 0)
    effect.change = LocalChange::death;
  else if (below.components != above.components)
    effect.change = below.components > above.components ? LocalChange::join : LocalChange::split;
  else if (effect.euler_change != 0)
    effect.change = effect.euler_change < 0 ? LocalChange::open : LocalChange::close;
  else
    effect.change = LocalChange::other;
  return effect;
}

}  // namespace tensortopo
