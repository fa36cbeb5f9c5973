// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/proofs/is_above.hpp"
#include "extract/run/count_predicate.hpp"

#include "extract/level/exact_side.hpp"
#include "extract/level/exact_tensors.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::type_identity_t<ExactPlace<Vertices>>& place, const Level<Scalar>& level,
              double total) {
  Verdict verdict = side_of_level(tensor, level, total);
  Tier tier = Tier::fast;
  if (verdict == Verdict::unknown) {
    verdict = side_in_multiprecision(simplex, place, level);
    tier = verdict == Verdict::unknown ? Tier::exact : Tier::multiprecision;
  }
  count_predicate(tier);
  if (verdict != Verdict::unknown) return verdict == Verdict::positive;
  const auto exact = detail::exact_tensors(simplex);
  // The level is mu + 0: a point exactly on mu counts as below.
  return exact_side_of_level(exact, simplex.exponents, place.high, place.low, level.value) ==
         Sign::positive;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                            \
  template bool is_above(const LevelSimplex<Scalar, 2>&, const Deviator<Scalar>&, \
                         const ExactPlace<2>&, const Level<Scalar>&, double);     \
  template bool is_above(const LevelSimplex<Scalar, 3>&, const Deviator<Scalar>&, \
                         const ExactPlace<3>&, const Level<Scalar>&, double);     \
  template bool is_above(const LevelSimplex<Scalar, 4>&, const Deviator<Scalar>&, \
                         const ExactPlace<4>&, const Level<Scalar>&, double);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
