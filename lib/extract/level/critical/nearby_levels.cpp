// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/critical/nearby_levels.hpp"

#include "extract/level/critical/degenerate_configuration.hpp"
#include "extract/level/critical/zero_inside.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {

namespace {

/// Levels of number k are 2^-k of the distance to mode +-1 from mu. At a critical point curves that
/// are meshed at the first of these are off by some 2^-16, elsewhere by 2^-32.
constexpr int kNear[] = {40, 46};
constexpr int kClose = 12;
constexpr int kFar[] = {1, 2, 3, 4, 6, 8, 10, 13, 16, 20, 25, 30};

/// Of a fraction, so that there is room for another; modes have 300 digits at most.
constexpr std::size_t kLongestText = 200;

/// Larger by 2^-step of the distance from mu to +-1, or smaller.
ModeValue moved(const ModeValue& mu, int step, bool larger) {
  const auto value = to_scalar<Rational>(mu);
  Rational length = Rational(1) - abs(value);
  for (int i = 0; i < step; ++i) length /= 2;
  return ModeValue::parse(Rational(larger ? value + length : value - length).str());
}

}  // namespace

template <class Scalar>
const Level<Scalar>& NearbyLevels<Scalar>::level(int step, bool larger) {
  const std::lock_guard lock(mutex_);
  auto& level = levels_[{step, larger}];
  if (!level) level = std::make_unique<Level<Scalar>>(make_level<Scalar>(moved(mu_, step, larger)));
  return *level;
}

template <class Scalar>
bool NearbyLevels<Scalar>::is_free(std::span<const SymmetricTensor<double>> tensors, int step,
                                   bool larger, OwnLevel own) {
  const ModeValue& other = level(step, larger).value;
  // The sign stays, on which other choices rest.
  return other.sign() * mu_.sign() >= 0 && is_free_of_critical_values(tensors, mu_, other, own);
}

template <class Scalar>
bool NearbyLevels<Scalar>::is_close_to_critical(std::span<const SymmetricTensor<double>> tensors) {
  return mu_.text().size() <= kLongestText && !has_zero_inside(tensors) &&
         (!is_free(tensors, kClose, true, OwnLevel::included) ||
          !is_free(tensors, kClose, false, OwnLevel::included));
}

/// The level `more` steps nearer than the first, on either side, that may be moved to.
template <class Scalar>
const Level<Scalar>* NearbyLevels<Scalar>::first_free(
    std::span<const SymmetricTensor<double>> tensors, std::span<const int> steps, int more) {
  if (mu_.text().size() > kLongestText || has_zero_inside(tensors)) return nullptr;
  // Nothing is meshed along a simplex of the very mode asked for: that is named.
  if (is_level_constant(tensors, mu_)) return nullptr;
  for (const int step : steps)
    for (const bool larger : {true, false}) {
      // Smaller modes have the topology of mu only if mu is not critical.
      if (!larger && mu_.sign() == 0) continue;
      if (is_free(tensors, step, larger, larger ? OwnLevel::excluded : OwnLevel::included))
        return &level(step + more, larger);
    }
  return nullptr;
}

template <class Scalar>
const Level<Scalar>* NearbyLevels<Scalar>::level_for(
    std::span<const SymmetricTensor<double>> tensors) {
  return first_free(tensors, kNear, 0);
}

template <class Scalar>
const Level<Scalar>* NearbyLevels<Scalar>::far_level_for(
    std::span<const SymmetricTensor<double>> tensors) {
  return first_free(tensors, kFar, 1);  // halfway to where a critical value may be
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class NearbyLevels<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
