// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/simd/lane_kernels.hpp"

#include <algorithm>

#include "extract/level/multiprecision_level.hpp"
#include "extract/level/simd/four_arcs.hpp"
#include "extract/level/simd/four_lanes.hpp"

namespace tensortopo {

namespace {

[[maybe_unused]] LevelNumbers numbers_of(const Level<double>& level) {
  return {level.mu, level.sqrt2, level.sign, level.eigenvalues[1]};
}

}  // namespace

template <std::size_t Vertices>
void prove_simplices(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                     const Level<double>& level, std::span<SimplexProof<double, Vertices>> proofs) {
  using Proof = SimplexProof<double, Vertices>;
  [[maybe_unused]] const bool in_lanes = has_lanes();
  std::array<std::array<double, Vertices>, kLaneCount> directions;
  for (std::size_t i = 0; i < tensors.size(); i += kLaneCount) {
    const auto four = tensors.subspan(i, std::min(kLaneCount, tensors.size() - i));
    LaneProofs done{0, 0};
#ifdef TENSORTOPO_FOUR_LANES
    if (in_lanes) done = prove_four(four, numbers_of(level), directions);
#endif
    for (std::size_t lane = 0; lane < four.size(); ++lane) {
      const bool monotone = done.monotone >> lane & 1, none = done.none >> lane & 1;
      proofs[i + lane] =
          monotone || none
              ? Proof{monotone ? Proof::Kind::monotone : Proof::Kind::none, directions[lane], false}
              : prove_simplex(four[lane], level);
    }
  }
}

template <std::size_t Vertices>
void prove_empty(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                 const Level<double>& level, std::span<char> empty) {
  [[maybe_unused]] const bool in_lanes = has_lanes();
  for (std::size_t i = 0; i < tensors.size(); i += kLaneCount) {
    const auto four = tensors.subspan(i, std::min(kLaneCount, tensors.size() - i));
    LaneEmptiness done{0, 0};
#ifdef TENSORTOPO_FOUR_LANES
    if (in_lanes) done = empty_four(four, numbers_of(level));
#endif
    for (std::size_t lane = 0; lane < four.size(); ++lane)
      empty[i + lane] = done.known >> lane & 1 ? (done.empty >> lane & 1) != 0
                                               : is_proved_empty(four[lane], level);
  }
}

void single_crossings(std::span<const std::array<Deviator<double>, 2>> ends,
                      [[maybe_unused]] std::span<const char> rising, const Level<double>& level,
                      std::span<double> weights) {
  if (!has_lanes() || is_inconclusive_in_double(level)) {
    std::fill(weights.begin(), weights.end(), -1.0);
    return;
  }
#ifdef TENSORTOPO_FOUR_LANES
  for (std::size_t i = 0; i < ends.size(); i += kLaneCount) {
    const std::size_t count = std::min(kLaneCount, ends.size() - i);
    cross_four(ends.subspan(i, count), rising.subspan(i, count), numbers_of(level),
               weights.subspan(i, count));
  }
#endif
}

void straight_arcs([[maybe_unused]] std::span<const GraphArc> arcs, const Level<double>& level,
                   [[maybe_unused]] const LeastCosines& least, std::span<char> straight) {
  std::fill(straight.begin(), straight.end(), char{0});
  if (!has_lanes() || is_inconclusive_in_double(level)) return;
#ifdef TENSORTOPO_FOUR_LANES
  for (std::size_t i = 0; i < arcs.size(); i += kLaneCount) {
    const std::size_t count = std::min(kLaneCount, arcs.size() - i);
    const unsigned bits = straight_four(arcs.subspan(i, count), numbers_of(level), least);
    for (std::size_t lane = 0; lane < count; ++lane) straight[i + lane] = bits >> lane & 1;
  }
#endif
}

template void prove_empty<2>(std::span<const std::array<Deviator<double>, 2>>, const Level<double>&,
                             std::span<char>);
template void prove_empty<3>(std::span<const std::array<Deviator<double>, 3>>, const Level<double>&,
                             std::span<char>);
template void prove_empty<4>(std::span<const std::array<Deviator<double>, 4>>, const Level<double>&,
                             std::span<char>);
template void prove_simplices<3>(std::span<const std::array<Deviator<double>, 3>>,
                                 const Level<double>&, std::span<SimplexProof<double, 3>>);
template void prove_simplices<4>(std::span<const std::array<Deviator<double>, 4>>,
                                 const Level<double>&, std::span<SimplexProof<double, 4>>);

}  // namespace tensortopo
