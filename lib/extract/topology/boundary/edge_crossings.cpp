// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/edge_crossings.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "extract/level/proofs/is_above.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/refinement_vertex.hpp"
#include "extract/subdivision/small_field.hpp"

namespace tensortopo {

namespace {

constexpr double kSmallestPart = 1.0 / (1ull << 48);
/// Coordinates have too many bits before.
constexpr int kDeepest = 120;

template <class Scalar>
struct EdgePoint {
  double weight;
  Deviator<Scalar> tensor;
  bool above;
};

template <class Scalar>
bool collect(const LevelSimplex<Scalar, 2>& edge, const Level<Scalar>& level,
             const EdgePoint<Scalar>& from, const EdgePoint<Scalar>& to,
             std::vector<EdgeCrossing<Scalar>>& crossings) {
  const std::array<std::array<double, 2>, 2> ends{
      {{1 - from.weight, from.weight}, {1 - to.weight, to.weight}}};
  if (edge_is_simple<Scalar, 2>(edge, ends, {from.tensor, to.tensor}, level)) {
    if (from.above == to.above) return true;
    const bool rising = to.above;
    const Scalar fraction = segment_root(from.tensor, to.tensor, rising, level);
    crossings.push_back({Scalar(from.weight) + fraction * Scalar(to.weight - from.weight), rising});
    return true;
  }
  if (to.weight - from.weight < kSmallestPart) return false;
  EdgePoint<Scalar> middle;
  middle.weight = (from.weight + to.weight) / 2;
  const std::array<double, 2> weights{1 - middle.weight, middle.weight};
  middle.tensor = tensor_at(edge.tensors, weights);
  middle.above = is_above(edge, middle.tensor, weights, level);
  return collect(edge, level, from, middle, crossings) &&
         collect(edge, level, middle, to, crossings);
}

/// For an edge on which the field nearly vanishes: all its crossings may be closer to each other
/// than halves of the edge ever get.
template <class Scalar>
bool collect_around_small(const LevelSimplex<Scalar, 2>& edge, const Level<Scalar>& level,
                          const RefinementVertex<Scalar, 2>& from,
                          const RefinementVertex<Scalar, 2>& to, int depth,
                          std::vector<EdgeCrossing<Scalar>>& crossings) {
  if (edge_is_simple<Scalar, 2>(edge, {from.exact(), to.exact()}, {from.tensor, to.tensor}, level,
                                std::max(from.total, to.total))) {
    if (from.above == to.above) return true;
    const bool rising = to.above;
    const Scalar f = segment_root(from.tensor, to.tensor, rising, level);
    const auto at = [&](std::size_t i) {
      return Scalar(from.weights[i]) + f * Scalar(to.weights[i] - from.weights[i]);
    };
    crossings.push_back({at(1) / (at(0) + at(1)), rising});
    return true;
  }
  if (depth == kDeepest) return false;
  const auto shares = detail::shares_of_cut(from, to, {1, 1});
  const auto middle = detail::place_among<Scalar, 2, 2>(edge, level, shares, {&from, &to});
  return middle && collect_around_small(edge, level, from, middle->vertex, depth + 1, crossings) &&
         collect_around_small(edge, level, middle->vertex, to, depth + 1, crossings);
}

}  // namespace

template <class Scalar>
std::optional<std::vector<EdgeCrossing<Scalar>>> edge_crossings(const LevelSimplex<Scalar, 2>& edge,
                                                                const Level<Scalar>& level) {
  std::vector<EdgeCrossing<Scalar>> crossings;
  const auto from = detail::corner_vertex(edge, 0), to = detail::corner_vertex(edge, 1);
  if (detail::shares_of_cut(from, to, {1, 1}) != detail::Shares<2>{1, 1}) {
    if (!collect_around_small(edge, level, from, to, 0, crossings)) return std::nullopt;
    return crossings;
  }
  const EdgePoint<Scalar> first{0.0, edge.tensors[0], edge.above[0]};
  const EdgePoint<Scalar> second{1.0, edge.tensors[1], edge.above[1]};
  if (!collect(edge, level, first, second, crossings)) return std::nullopt;
  return crossings;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                      \
  template std::optional<std::vector<EdgeCrossing<Scalar>>> edge_crossings( \
      const LevelSimplex<Scalar, 2>&, const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
