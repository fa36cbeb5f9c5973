// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "count_predicate.hpp"
#include "extractor_scalars.hpp"
#include "tensortopo/extract/exact_side.hpp"
#include "tensortopo/extract/refinement.hpp"
#include "tiers.hpp"

namespace tensortopo {

template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::array<double, Vertices>& weights, const Level<Scalar>& level) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Verdict verdict = side_of_level(tensor, level, total);
  Tier tier = Tier::fast;
  if (verdict == Verdict::unknown) {
    verdict = side_in_longer_scalar(simplex, weights, level);
    tier = verdict == Verdict::unknown ? Tier::exact : Tier::longer;
  }
  count_predicate(tier);
  if (verdict != Verdict::unknown) return verdict == Verdict::positive;
  std::array<SymmetricTensor<double>, Vertices> exact;
  for (std::size_t i = 0; i < Vertices; ++i) exact[i] = *simplex.exact[i];
  // The level is mu + 0: a point exactly on mu counts as below.
  return exact_side_of_level(exact, simplex.exponents, weights, level.value) == Sign::positive;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                            \
  template bool is_above(const LevelSimplex<Scalar, 2>&, const Deviator<Scalar>&, \
                         const std::array<double, 2>&, const Level<Scalar>&);     \
  template bool is_above(const LevelSimplex<Scalar, 3>&, const Deviator<Scalar>&, \
                         const std::array<double, 3>&, const Level<Scalar>&);     \
  template bool is_above(const LevelSimplex<Scalar, 4>&, const Deviator<Scalar>&, \
                         const std::array<double, 4>&, const Level<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
