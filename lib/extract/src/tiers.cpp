// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tiers.hpp"

#include <algorithm>
#include <numeric>

#include "count_predicate.hpp"
#include "extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// The scalar to turn to when rounding hides a sign.
template <class Scalar>
struct Longer;
template <>
struct Longer<double> {
  using type = Real50;
};
template <>
struct Longer<Real50> {
  using type = Real100;
};

/// The level in another scalar; the last one asked for is kept, as all of a run ask for the same.
template <class Scalar>
const Level<Scalar>& level_in(const ModeValue& value) {
  thread_local Level<Scalar> level;
  thread_local bool made = false;
  if (!made || !(level.value == value)) {
    level = make_level<Scalar>(value);
    made = true;
  }
  return level;
}

/// The field of the root simplex at some of its points, from the input's bits.
template <class Long, class Scalar, std::size_t Vertices, std::size_t Part>
std::array<Deviator<Long>, Part> tensors_in(
    const LevelSimplex<Scalar, Vertices>& root,
    const std::array<std::array<double, Vertices>, Part>& weights) {
  std::array<Deviator<Long>, Vertices> corners;
  for (std::size_t i = 0; i < Vertices; ++i) {
    using std::ldexp;
    const auto& t = *root.exact[i];
    const auto exact = tensor_cast<Long>(t);
    const Long scale = ldexp(Long(1), root.exponents[i]);
    corners[i] = scale * deviator(exact);
  }
  std::array<Deviator<Long>, Part> result;
  for (std::size_t p = 0; p < Part; ++p) {
    std::array<Long, Vertices> w;
    for (std::size_t i = 0; i < Vertices; ++i) w[i] = Long(weights[p][i]);
    result[p] = tensor_at(corners, w);
  }
  return result;
}

template <std::size_t Vertices, std::size_t Part>
double largest_sum(const std::array<std::array<double, Vertices>, Part>& weights) {
  double largest = 0;
  for (const auto& w : weights)
    largest = std::max(largest, std::accumulate(w.begin(), w.end(), 0.0));
  return largest;
}

}  // namespace

template <class Scalar, std::size_t Vertices, std::size_t Part>
SimplexProof<Scalar, Part> prove_part(const LevelSimplex<Scalar, Vertices>& root,
                                      const std::array<std::array<double, Vertices>, Part>& weights,
                                      const std::array<Deviator<Scalar>, Part>& tensors,
                                      const Level<Scalar>& level) {
  const double total = largest_sum(weights);
  auto proof = prove_simplex(tensors, level, total, kShortSearch);
  count_predicate(proof.hidden_by_rounding ? Tier::longer : Tier::fast);
  if (!proof.hidden_by_rounding) return proof;
  using Long = typename Longer<Scalar>::type;
  const auto better = prove_simplex(tensors_in<Long>(root, weights), level_in<Long>(level.value),
                                    total, kShortSearch);
  using Better = SimplexProof<Long, Part>;
  using Proof = SimplexProof<Scalar, Part>;
  proof.kind = better.kind == Better::Kind::empty      ? Proof::Kind::empty
               : better.kind == Better::Kind::monotone ? Proof::Kind::monotone
                                                       : Proof::Kind::none;
  for (std::size_t i = 0; i < Part; ++i)
    proof.direction[i] = static_cast<Scalar>(better.direction[i]);
  return proof;
}

template <class Scalar, std::size_t Vertices>
bool edge_is_simple(const LevelSimplex<Scalar, Vertices>& root,
                    const std::array<std::array<double, Vertices>, 2>& weights,
                    const std::array<Deviator<Scalar>, 2>& tensors, const Level<Scalar>& level) {
  const double total = largest_sum(weights);
  const Verdict verdict = has_at_most_one_crossing(tensors, level, total);
  count_predicate(verdict == Verdict::unknown ? Tier::longer : Tier::fast);
  if (verdict != Verdict::unknown) return verdict == Verdict::positive;
  using Long = typename Longer<Scalar>::type;
  return has_at_most_one_crossing(tensors_in<Long>(root, weights), level_in<Long>(level.value),
                                  total) == Verdict::positive;
}

template <class Scalar, std::size_t Vertices>
Verdict side_in_longer_scalar(const LevelSimplex<Scalar, Vertices>& root,
                              const std::array<double, Vertices>& weights,
                              const Level<Scalar>& level) {
  using Long = typename Longer<Scalar>::type;
  const std::array<std::array<double, Vertices>, 1> places{weights};
  return side_of_level(tensors_in<Long>(root, places)[0], level_in<Long>(level.value),
                       largest_sum(places));
}

#define TENSORTOPO_INSTANTIATE_PART(Scalar, Vertices, Part)  \
  template SimplexProof<Scalar, Part> prove_part(            \
      const LevelSimplex<Scalar, Vertices>&,                 \
      const std::array<std::array<double, Vertices>, Part>&, \
      const std::array<Deviator<Scalar>, Part>&, const Level<Scalar>&);
#define TENSORTOPO_INSTANTIATE_EDGE(Scalar, Vertices)                              \
  template bool edge_is_simple(const LevelSimplex<Scalar, Vertices>&,              \
                               const std::array<std::array<double, Vertices>, 2>&, \
                               const std::array<Deviator<Scalar>, 2>&, const Level<Scalar>&);
#define TENSORTOPO_INSTANTIATE_SIDE(Scalar, Vertices)                           \
  template Verdict side_in_longer_scalar(const LevelSimplex<Scalar, Vertices>&, \
                                         const std::array<double, Vertices>&,   \
                                         const Level<Scalar>&);
#define TENSORTOPO_INSTANTIATE(Scalar)      \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 2)    \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 3)    \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 4)    \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 3, 3) \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 4, 3) \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 4, 4) \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 2)    \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 3)    \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 4)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_EDGE
#undef TENSORTOPO_INSTANTIATE_PART
#undef TENSORTOPO_INSTANTIATE_SIDE

}  // namespace tensortopo
