// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "extract/level/level.hpp"
#include "tensortopo/field/critical_values.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Levels next to mu that stand for mu + 0 where mu is a critical value of the mode, or next to
/// one, so that no proof closes at mu itself.
template <class Scalar>
class NearbyLevels {
 public:
  explicit NearbyLevels(const ModeValue& mu) : mu_(mu) {}
  NearbyLevels(const NearbyLevels&) = delete;
  NearbyLevels& operator=(const NearbyLevels&) = delete;

  /// Whether a critical value is at mu or close to it. If not, what hinders a proof at mu hinders
  /// it at nearby levels as well.
  bool is_close_to_critical(std::span<const SymmetricTensor<double>> tensors);

  /// A level that has the topology of mu + 0 in a simplex and in its faces, edges and vertices:
  /// none of them has a critical value in between. It depends on mu and these tensors only.
  /// Thread-safe.
  /// @param tensors at the vertices, none of them isotropic
  /// @return lives as long as this; null if critical values leave no room, if the deviator
  ///         vanishes inside, or if the mode is mu everywhere on the simplex
  const Level<Scalar>* level_for(std::span<const SymmetricTensor<double>> tensors);

  /// Another such level, as far away as may be, where proofs are short.
  const Level<Scalar>* far_level_for(std::span<const SymmetricTensor<double>> tensors);

 private:
  const Level<Scalar>* first_free(std::span<const SymmetricTensor<double>> tensors,
                                  std::span<const int> steps, int more);
  const Level<Scalar>& level(int step, bool larger);
  bool is_free(std::span<const SymmetricTensor<double>> tensors, int step, bool larger,
               OwnLevel own);

  ModeValue mu_;
  std::mutex mutex_;
  std::map<std::pair<int, bool>, std::unique_ptr<Level<Scalar>>> levels_;
};

}  // namespace tensortopo
