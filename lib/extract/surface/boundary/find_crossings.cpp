// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/boundary/find_crossings.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include "extract/level/simd/proof_block.hpp"
#include "extract/run/assert.hpp"
#include "extract/run/count_predicate.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"

namespace tensortopo {

namespace {

template <class Scalar>
using Crossings = std::optional<std::vector<EdgeCrossing<Scalar>>>;

/// The crossings of an edge that is not known to have just one.
/// @param moved  receives whether they are those of a nearby level
template <class Scalar>
Crossings<Scalar> crossings_of(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                               const std::array<TetMesh::Index, 2>& v, char& moved) {
  // The mode is constant on the edge, or undefined.
  if (input.field.is_zero[as_size(v[0])] || input.field.is_zero[as_size(v[1])])
    return std::vector<EdgeCrossing<Scalar>>();
  if (is_clear(input, sides, v)) {
    count_predicate(Tier::fast);
    return std::vector<EdgeCrossing<Scalar>>();
  }
  const auto edge = input.field.template simplex<2>(v, sides.above);
  const bool keeps_off = sides.keeps_off(v);
  Crossings<Scalar> crossings;
  if (!keeps_off) crossings = edge_crossings(edge, input.level);
  if (crossings) return crossings;
  const auto tensors = input.tensors_of(v);
  if (keeps_off || input.nearby_levels.is_close_to_critical(tensors))
    if (const auto* level = input.nearby_levels.level_for(tensors))
      crossings = edge_crossings(edge, *level);
  moved = crossings.has_value();
  if (keeps_off && !crossings) crossings = edge_crossings(edge, input.level);
  return crossings;
}

/// Whether crossings are in order along the edge, rise and fall in turn, and lead from the side of
/// its first vertex to that of its second.
template <class Scalar>
[[maybe_unused]] bool are_crossings_sound(const VertexSides& sides,
                                          const std::array<TetMesh::Index, 2>& edge,
                                          const std::vector<EdgeCrossing<Scalar>>& crossings) {
  if (crossings.empty()) return true;
  bool above = sides.above[as_size(edge[0])] != 0;
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    if (crossings[k].rising == above) return false;
    if (k > 0 && crossings[k].weight < crossings[k - 1].weight) return false;
    above = !above;
  }
  return above == (sides.above[as_size(edge[1])] != 0);
}

}  // namespace

template <class Scalar>
MeshCrossings<Scalar> find_crossings(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                                     const TetComplex& cells) {
  MeshCrossings<Scalar> result;
  result.rows = Rows<EdgeCrossing<Scalar>>(cells.edges.size());
  result.moved.assign(cells.edges.size(), 0);
  const auto find = [&](std::size_t begin, std::size_t end) {
    CrossingBlock<Scalar> single;
    EmptyBlock<Scalar, 2> empty;
    for (std::size_t e = begin; e < end; ++e) {
      const auto& v = cells.edges[e];
      if (sides.keeps_off(v)) continue;
      if (is_crossed(input, sides, v))
        single.want(e - begin, v, input.field.tensors, sides.above[as_size(v[1])]);
      else if (!input.has_zero_vertex(v) && !is_clear(input, sides, v))
        empty.want(e - begin, v, input.field.tensors);
    }
    single.make(input.level);
    empty.make(input.level);
    for (std::size_t e = begin; e < end; ++e) {
      if (empty.is_empty(e - begin)) {
        count_predicate(Tier::fast);
        result.rows.add(e, {});
      } else if (const auto crossing = single.of(e - begin)) {
        count_predicate(Tier::fast);
        result.rows.add_one(e, *crossing);
      } else if (auto found = crossings_of(input, sides, cells.edges[e], result.moved[e])) {
        TENSORTOPO_ASSERT(are_crossings_sound(sides, cells.edges[e], *found),
                          "crossings of an edge are in order and change sides");
        result.rows.add(e, std::move(*found));
      } else {
        result.rows.add_unknown(e);
      }
    }
  };
  result.rows.fill(input.options, "edges", CrossingBlock<Scalar>::size, find);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template MeshCrossings<Scalar> find_crossings(const SurfaceInput<Scalar>&, const VertexSides&, \
                                                const TetComplex&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
