// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/graph_sheets.hpp"

#include <algorithm>
#include <cstddef>

#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

namespace {

/// How lines of a direction pass a tetrahedron.
class Silhouette {
 public:
  explicit Silhouette(const std::array<bool, 4>& enters) : enters_(enters) {}

  /// Whether an edge separates faces on which lines enter from those on which they leave.
  bool has_edge(std::size_t edge) const {
    const auto [k, l] = faces_at(edge);
    return enters_[k] != enters_[l];
  }
  bool has_vertex(std::size_t v) const {
    bool in = false, out = false;
    for (std::size_t f = 0; f < 4; ++f)
      if (f != v) (enters_[f] ? in : out) = true;
    return in && out;
  }
  /// Whether lines enter on both sides of an edge that is not on it.
  bool enters_at(std::size_t edge) const { return enters_[faces_at(edge)[0]]; }

 private:
  static std::array<std::size_t, 2> faces_at(std::size_t edge) {
    std::array<std::size_t, 2> faces{};
    std::size_t count = 0;
    for (std::size_t f = 0; f < 4; ++f)
      if (static_cast<int>(f) != kTetEdges[edge][0] && static_cast<int>(f) != kTetEdges[edge][1])
        faces[count++] = f;
    return faces;
  }

  std::array<bool, 4> enters_;  ///< at the face opposite each vertex
};

}  // namespace

template <class Scalar>
std::optional<Sheets> sheets_of_graph(const TetWithCurves<Scalar>& tet, const BoundaryLoops& loops,
                                      const std::array<Scalar, 4>& direction) {
  if (loops.size() == 1) {
    Sheets disc(1);
    disc[0].loops.push_back(0);
    return disc;
  }
  std::array<bool, 4> enters{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (direction[i] == Scalar(0)) return std::nullopt;
    enters[i] = direction[i] > Scalar(0);
  }
  const Silhouette silhouette(enters);
  std::vector<std::vector<CrossingKey>> crossings(loops.size());
  std::array<int, 6> count{};
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const auto& piece : loops[l]) {
      const auto& arc =
          tet.arcs[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)];
      if (arc.closed) return std::nullopt;
      crossings[l].push_back(crossing_of(tet, piece.face, piece.forward ? arc.begin : arc.end));
      ++count[static_cast<std::size_t>(crossings[l].back().first)];
    }
  std::size_t outer = 0;
  for (const auto& loop : crossings) {
    const auto meets = [&](const CrossingKey& c) {
      return silhouette.has_edge(static_cast<std::size_t>(c.first));
    };
    if (std::any_of(loop.begin(), loop.end(), meets)) {
      ++outer;
      continue;
    }
    // From a vertex on the silhouette, along an edge to the loop's first crossing: that is outside.
    const int edge = loop[0].first;
    const auto e = static_cast<std::size_t>(edge);
    const auto a = static_cast<std::size_t>(kTetEdges[e][0]),
               b = static_cast<std::size_t>(kTetEdges[e][1]);
    const auto from = silhouette.has_vertex(a) ? a : b;
    if (!silhouette.has_vertex(from)) return std::nullopt;
    int first = count[e];
    for (const auto& [on, k] : loop)
      if (on == edge)
        first = std::min(first, (from == a) == tet.edge_forward[e] ? k : count[e] - 1 - k);
    const bool above_outside = tet.simplex.above[from] == (first % 2 == 0);
    const bool goes_around_hole = silhouette.enters_at(e) != above_outside;
    outer += goes_around_hole ? 0 : 1;
  }
  Sheets sheets;
  if (outer == loops.size()) {
    for (std::size_t l = 0; l < loops.size(); ++l) sheets.push_back({{static_cast<int>(l)}, 1, -1});
    return sheets;
  }
  if (outer != 1) return std::nullopt;
  SheetTopology sheet;
  sheet.euler_characteristic = 2 - static_cast<int>(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l) sheet.loops.push_back(static_cast<int>(l));
  sheets.push_back(std::move(sheet));
  return sheets;
}

#define TENSORTOPO_INSTANTIATE(Scalar)            \
  template std::optional<Sheets> sheets_of_graph( \
      const TetWithCurves<Scalar>&, const BoundaryLoops&, const std::array<Scalar, 4>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
