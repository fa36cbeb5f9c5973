// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tensortopo/theory/trial.hpp"

namespace tensortopo::theory {

/// A trial in whole numbers, so that it can be changed a little and written down.
struct Candidate {
  /// Of the vertex tensors: xx - yy, yy - zz, xy, yz, xz of each. Not used with a frame.
  std::array<int, 20> entries{};
  /// Of the characteristic tensor, if `high` is not 0: its larger eigenvalues, and a quaternion for
  /// its eigenvectors. The vertex tensors are then drawn with the seed.
  int high = 0, middle = 0;
  std::array<int, 4> rotation{};
  std::uint32_t seed = 0;  ///< of the check's own choices

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

Trial trial_of(const Candidate& candidate);

/// One to start from: general, with many zeros, or with a frame.
Candidate random_candidate(Random& random);

/// The same with one number changed.
Candidate changed(const Candidate& candidate, Random& random);

/// How far the field is from the exceptional ones: the least of the mode of its characteristic
/// tensor, squared, of what that lacks to 1, and of the volume that its vertex tensors span, as a
/// part of the largest possible. In doubles; 0 below rank 4.
double distance_from_exceptional(const Candidate& candidate);

/// As an initializer in C++.
std::string text(const Candidate& candidate);

}  // namespace tensortopo::theory
