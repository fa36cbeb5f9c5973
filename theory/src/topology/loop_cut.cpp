// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/loop_cut.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "levels/tensor_sphere.hpp"
#include "topology/loop_arcs.hpp"
#include "topology/loop_crossings.hpp"

namespace tensortopo::theory {
namespace {

using FaceEdge = std::array<LevelComplex::Index, 2>;
using Face = LevelComplex::Face;

/// Points with a side each, of which some are known to be on the same side and some not.
class Sides {
 public:
  explicit Sides(std::size_t size) : parent_(size), differs_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  void join(std::size_t i, std::size_t j, bool differ) {
    const auto [a, of_i] = root(i);
    const auto [b, of_j] = root(j);
    const bool odd = (of_i + of_j + (differ ? 1 : 0)) % 2 == 1;
    if (a == b) {
      is_consistent_ = is_consistent_ && !odd;
    } else {
      parent_[a] = b;
      differs_[a] = odd ? 1 : 0;
    }
  }
  std::size_t part(std::size_t i) const { return root(i).first; }
  bool is_consistent() const { return is_consistent_; }

 private:
  std::pair<std::size_t, int> root(std::size_t i) const {
    int differs = 0;
    for (; parent_[i] != i; i = parent_[i]) differs ^= differs_[i];
    return {i, differs};
  }

  std::vector<std::size_t> parent_;
  std::vector<int> differs_;
  bool is_consistent_ = true;
};

// The arc of the surface in a face, between its points on two edges.
struct Link {
  std::size_t from, to;
  OddCrossings crossings;
  bool is_outer;  ///< in a face of the tetrahedron
};

struct Graph {
  std::map<FaceEdge, std::size_t> points;
  std::vector<Link> links;
};

std::optional<Graph> graph_of(const LevelComplex& complex, LoopCrossings& crossings) {
  std::map<Face, int> cells_at;
  for (const auto& cell : complex.cells())
    for (std::size_t k = 0; k < 4; ++k) {
      Face face{};
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != k) face[n++] = cell[i];
      std::sort(face.begin(), face.end());
      if (complex.is_met(face)) ++cells_at[face];
    }
  Graph graph;
  for (const auto& [face, cells] : cells_at) {
    std::vector<std::size_t> ends;
    for (const FaceEdge& edge :
         {FaceEdge{face[0], face[1]}, FaceEdge{face[1], face[2]}, FaceEdge{face[0], face[2]}})
      if (complex.is_above(edge[0]) != complex.is_above(edge[1]))
        ends.push_back(graph.points.try_emplace(edge, graph.points.size()).first->second);
    const auto found = crossings.of(face);
    if (!found) return std::nullopt;
    graph.links.push_back({ends[0], ends[1], *found, cells == 1});
  }
  return graph;
}

// Whether curves that links cross an odd number of times separate the surface in two, mod 2.
template <class IsOdd>
bool separates(const Graph& graph, const IsOdd& is_odd) {
  Sides sides(graph.points.size());
  for (const Link& link : graph.links) sides.join(link.from, link.to, is_odd(link.crossings));
  return sides.is_consistent();
}

}  // namespace

std::optional<LoopCut> cut_along_loops(const LoopTetrahedron& t) {
  const auto arcs = arcs_of_loop(t.values, t.s, t.vertices, -t.side);
  if (!arcs || *arcs > 1) return std::nullopt;
  LevelComplex complex = tensor_tetrahedron(t.deviators(), ModeLevel::of_parameter(t.s));
  LoopCrossings crossings(complex, t);
  if (!complex.refine(kCellBudget,
                      [&](const Face& face) { return crossings.of(face).has_value(); }))
    return std::nullopt;
  const auto graph = graph_of(complex, crossings);
  if (!graph) return std::nullopt;
  LoopCut result;
  result.surface = level_surface(complex);
  result.arcs = *arcs;
  result.sheets = result.surface.components +
                  (separates(*graph, [](const OddCrossings& c) { return c.loop; }) ? 1 : 0);
  result.pieces = result.sheets;
  result.boundary_loops = result.surface.boundary_loops;
  if (result.arcs == 0) return result;
  // The loop and the arc are disjoint; they cut off another piece for each of their sums that
  // separates, if independent of the loop alone.
  const bool arc = separates(*graph, [](const OddCrossings&c) { return c.other; }),
             both = separates(*graph, [](const OddCrossings&c) { return c.loop != c.other; });
  if (arc || both) ++result.pieces;
  // An arc from a boundary loop to itself makes two of it, one between two loops joins them. If no
  // arc in a face of the tetrahedron crosses it once, both ends are on the same.
  Sides boundary(graph->points.size());
  std::vector<std::size_t> ends;
  for (const Link& link : graph->links) {
    if (!link.is_outer) continue;
    boundary.join(link.from, link.to, false);
    if (link.crossings.other) ends.push_back(link.from);
  }
  const bool is_same = ends.empty() || boundary.part(ends[0]) == boundary.part(ends.back());
  result.boundary_loops += is_same ? 1 : -1;
  return result;
}

}  // namespace tensortopo::theory
