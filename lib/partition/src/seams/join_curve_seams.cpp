// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>
#include <utility>

#include "crossed_cells.hpp"
#include "curves/line_order.hpp"
#include "curves/piece_vertices.hpp"
#include "piece_messages.hpp"
#include "seams/joined_vertices.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/partition/curve_seam.hpp"

namespace tensortopo {

namespace {

using Counts = JoinedCurveSeams::Component;

void add_counts(Counts& sum, const Counts& more) {
  sum.vertices += more.vertices, sum.lines += more.lines;
  sum.ends += more.ends, sum.junctions += more.junctions;
}

/// Where lines of several pieces may end, how many do, and that all pieces saw the same.
void count_ends(std::span<const CurveSeam> seams, const SeamComponents<CurveSeam>& components,
                const JoinedVertices& joined, std::vector<Counts>& counts) {
  std::vector<std::int64_t> line_ends(joined.vertices.size(), 0);
  std::vector<std::uint64_t> owned(joined.vertices.size(), 0);
  const auto for_each = [&](const auto& visit) {
    for (std::size_t s = 0; s < seams.size(); ++s)
      for (std::size_t v = 0; v < seams[s].vertices.size(); ++v)
        visit(seams[s].vertices[v], joined.of_seam[s][v]);
  };
  for_each([&](const CurveSeam::Vertex& vertex, std::uint32_t at) {
    line_ends[at] += vertex.line_ends, owned[at] += vertex.owned;
  });
  for_each([&](const CurveSeam::Vertex& vertex, std::uint32_t at) {
    if (vertex.around != owned[at]) refuse_simplex("curves differ", vertex.carrier_ids);
  });
  for (std::size_t i = 0; i < joined.vertices.size(); ++i) {
    const auto& [seam, place] = joined.vertices[i];
    auto& own = counts[components.at(seam, seams[seam].vertices[place].component)];
    own.ends += line_ends[i] == 1, own.junctions += line_ends[i] > 2;
  }
}

/// By the cells of first lines; those of one cell are in one piece, in order.
std::vector<std::uint32_t> order_of_first_lines(std::span<const CurveSeam> seams,
                                                const SeamComponents<CurveSeam>& components) {
  const CrossedCells cells = crossed_cells(seams);
  const auto rank = inverse_permutation(canonical_mesh(cells.mesh).vertices);
  std::vector<std::pair<CellOrder, std::uint32_t>> order;
  for (std::size_t s = 0; s < seams.size(); ++s)
    for (std::size_t c = 0; c < seams[s].components.size(); ++c) {
      auto cell = seams[s].components[c].first_cell;
      for (auto& v : cell)
        if (v >= 0) v = cells.vertex_of[s][as_size(v)];
      order.emplace_back(order_of_cell(cell, rank),
                         components.at(s, static_cast<TetMesh::Index>(c)));
    }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> result;
  for (const auto& [cell, component] : order) result.push_back(component);
  return result;
}

}  // namespace

JoinedCurveSeams::Component JoinedCurveSeams::total() const {
  Component sum;
  for (const Component& component : components) add_counts(sum, component);
  return sum;
}

std::int64_t JoinedCurveSeams::closed_components() const {
  return std::count_if(components.begin(), components.end(),
                       [](const Component& component) { return component.ends == 0; });
}

JoinedCurveSeams join_curve_seams(std::span<const CurveSeam> seams) {
  require_all_cells(seams);
  require_one_kind(seams);
  require_same_messages(seams);
  SeamComponents<CurveSeam> components(seams);
  std::vector<Counts> counts;
  for (const CurveSeam& seam : seams)
    for (const auto& own : seam.components)
      counts.push_back({own.vertices, own.lines, own.ends, own.junctions});
  const JoinedVertices joined = join_vertices(
      seams, components, [&](std::uint32_t component) { --counts[component].vertices; });
  count_ends(seams, components, joined, counts);
  components.number(order_of_first_lines(seams, components));
  JoinedCurveSeams result;
  result.components.resize(components.count());
  for (std::uint32_t c = 0; c < counts.size(); ++c)
    add_counts(result.components[as_size(components.number_of(c))], counts[c]);
  result.numbers = components.numbers();
  return result;
}

}  // namespace tensortopo
