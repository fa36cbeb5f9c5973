// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/proofs/tiers.hpp"

#include <algorithm>
#include <numeric>

#include "extract/level/multiprecision_level.hpp"
#include "extract/run/count_predicate.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// The field of the root simplex at some of its points, from the input's bits.
template <class Wide, class Scalar, std::size_t Vertices, std::size_t Part>
std::array<Deviator<Wide>, Part> tensors_in(const LevelSimplex<Scalar, Vertices>& root,
                                            const std::array<ExactPlace<Vertices>, Part>& places) {
  std::array<Deviator<Wide>, Vertices> corners;
  for (std::size_t i = 0; i < Vertices; ++i) {
    using std::ldexp;
    const auto& t = *root.exact[i];
    const auto exact = tensor_cast<Wide>(t);
    const Wide scale = ldexp(Wide(1), root.exponents[i]);
    corners[i] = scale * deviator(exact);
  }
  std::array<Deviator<Wide>, Part> result;
  for (std::size_t p = 0; p < Part; ++p) {
    std::array<Wide, Vertices> w;
    for (std::size_t i = 0; i < Vertices; ++i) {
      w[i] = Wide(places[p].high[i]);
      if (places[p].low[i] != 0) w[i] += Wide(places[p].low[i]);
    }
    result[p] = tensor_at(corners, w);
  }
  return result;
}

/// Where the vertices of a part are, as far as rounding lets one tell.
enum class Sides { same, different, unknown };

template <class Scalar, std::size_t Part>
Sides sides_of(const std::array<Deviator<Scalar>, Part>& tensors, const Level<Scalar>& level,
               double total) {
  bool above = false, below = false, unknown = false;
  for (const auto& t : tensors) {
    const Verdict side = side_of_level(t, level, total);
    (side == Verdict::positive ? above : side == Verdict::negative ? below : unknown) = true;
  }
  if (above && below) return Sides::different;
  return unknown ? Sides::unknown : Sides::same;
}

/// Of the coordinates; a bit more, for those that are rounded.
template <std::size_t Vertices, std::size_t Part>
double largest_sum(const std::array<ExactPlace<Vertices>, Part>& places) {
  double largest = 0;
  for (const auto& p : places)
    largest = std::max(largest, std::accumulate(p.high.begin(), p.high.end(), 0.0));
  return largest * (1 + 0x1p-50);
}

}  // namespace

template <class Scalar, std::size_t Vertices, std::size_t Part>
SimplexProof<Scalar, Part> prove_part(const LevelSimplex<Scalar, Vertices>& root,
                                      const std::array<ExactPlace<Vertices>, Part>& places,
                                      const std::array<Deviator<Scalar>, Part>& tensors,
                                      const Level<Scalar>& level, double total) {
  using Proof = SimplexProof<Scalar, Part>;
  auto proof = prove_simplex(tensors, level, total, kShortSearch);
  // Vertices that only seem to be on different sides keep it from trying whether the part is empty.
  if (proof.kind == Proof::Kind::none && !proof.inconclusive && is_inconclusive_in_double(level))
    proof.inconclusive = sides_of(tensors, level, total) == Sides::unknown;
  count_predicate(proof.inconclusive ? Tier::multiprecision : Tier::fast);
  if (!proof.inconclusive) return proof;
  using Wide = typename Multiprecision<Scalar>::type;
  using Better = SimplexProof<Wide, Part>;
  const auto multiprecision = tensors_in<Wide>(root, places);
  const auto& same_level = level_in<Wide>(level.value);
  total = largest_sum(places);
  auto better = prove_simplex(multiprecision, same_level, total, kShortSearch);
  if (better.kind == Better::Kind::none &&
      sides_of(multiprecision, same_level, total) == Sides::same &&
      is_proved_empty(multiprecision, same_level, total))
    better.kind = Better::Kind::empty;
  proof.kind = better.kind == Better::Kind::empty      ? Proof::Kind::empty
               : better.kind == Better::Kind::monotone ? Proof::Kind::monotone
                                                       : Proof::Kind::none;
  for (std::size_t i = 0; i < Part; ++i)
    proof.direction[i] = static_cast<Scalar>(better.direction[i]);
  return proof;
}

template <class Scalar, std::size_t Vertices>
bool edge_is_simple(const LevelSimplex<Scalar, Vertices>& root,
                    const std::array<ExactPlace<Vertices>, 2>& places,
                    const std::array<Deviator<Scalar>, 2>& tensors, const Level<Scalar>& level,
                    double total) {
  const Verdict verdict = has_at_most_one_crossing(tensors, level, total);
  count_predicate(verdict == Verdict::unknown ? Tier::multiprecision : Tier::fast);
  if (verdict != Verdict::unknown) return verdict == Verdict::positive;
  using Wide = typename Multiprecision<Scalar>::type;
  return has_at_most_one_crossing(tensors_in<Wide>(root, places), level_in<Wide>(level.value),
                                  largest_sum(places)) == Verdict::positive;
}

template <class Scalar, std::size_t Vertices>
Verdict side_in_multiprecision(const LevelSimplex<Scalar, Vertices>& root,
                               const ExactPlace<Vertices>& place, const Level<Scalar>& level) {
  using Wide = typename Multiprecision<Scalar>::type;
  const std::array<ExactPlace<Vertices>, 1> places{place};
  return side_of_level(tensors_in<Wide>(root, places)[0], level_in<Wide>(level.value),
                       largest_sum(places));
}

template <class Scalar, std::size_t Vertices>
Deviator<Scalar> tensor_in_multiprecision(const LevelSimplex<Scalar, Vertices>& root,
                                          const ExactPlace<Vertices>& place) {
  using Wide = typename Multiprecision<Scalar>::type;
  return tensor_cast<Scalar>(tensors_in<Wide>(root, std::array<ExactPlace<Vertices>, 1>{place})[0]);
}

#define TENSORTOPO_INSTANTIATE_PART(Scalar, Vertices, Part)                                 \
  template SimplexProof<Scalar, Part> prove_part(                                           \
      const LevelSimplex<Scalar, Vertices>&, const std::array<ExactPlace<Vertices>, Part>&, \
      const std::array<Deviator<Scalar>, Part>&, const Level<Scalar>&, double);
#define TENSORTOPO_INSTANTIATE_EDGE(Scalar, Vertices)                                    \
  template bool edge_is_simple(                                                          \
      const LevelSimplex<Scalar, Vertices>&, const std::array<ExactPlace<Vertices>, 2>&, \
      const std::array<Deviator<Scalar>, 2>&, const Level<Scalar>&, double);
#define TENSORTOPO_INSTANTIATE_SIDE(Scalar, Vertices)                            \
  template Verdict side_in_multiprecision(const LevelSimplex<Scalar, Vertices>&, \
                                          const ExactPlace<Vertices>&, const Level<Scalar>&);
#define TENSORTOPO_INSTANTIATE_TENSOR(Scalar, Vertices)                                     \
  template Deviator<Scalar> tensor_in_multiprecision(const LevelSimplex<Scalar, Vertices>&, \
                                                     const ExactPlace<Vertices>&);
#define TENSORTOPO_INSTANTIATE(Scalar)      \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 2)    \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 3)    \
  TENSORTOPO_INSTANTIATE_SIDE(Scalar, 4)    \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 3, 3) \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 4, 3) \
  TENSORTOPO_INSTANTIATE_PART(Scalar, 4, 4) \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 2)    \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 3)    \
  TENSORTOPO_INSTANTIATE_EDGE(Scalar, 4)    \
  TENSORTOPO_INSTANTIATE_TENSOR(Scalar, 2)  \
  TENSORTOPO_INSTANTIATE_TENSOR(Scalar, 3)  \
  TENSORTOPO_INSTANTIATE_TENSOR(Scalar, 4)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_TENSOR
#undef TENSORTOPO_INSTANTIATE_EDGE
#undef TENSORTOPO_INSTANTIATE_PART
#undef TENSORTOPO_INSTANTIATE_SIDE

}  // namespace tensortopo
