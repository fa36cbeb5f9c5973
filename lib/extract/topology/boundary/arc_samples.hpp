// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "extract/topology/boundary/face_curves.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

/// Cosines of the largest angles between medium eigenvectors, and between tensors, of neighbouring
/// samples.
struct SampleTurns {
  double medium, tensor;

  explicit SampleTurns(const Sampling& sampling)
      : medium(elementary::cos(std::min(sampling.largest_turn(), 1.5))),
        tensor(elementary::cos(std::min(2 * sampling.largest_turn(), 0.5))) {}
};

/// Samples the arc so that neither the medium eigenvector nor the tensor turns too far from one
/// sample to the next, and no chord sags by more than `detail::kLargestSag`.
template <class Scalar>
void sample_arc(FaceArc<Scalar>& arc, const std::array<Deviator<Scalar>, 3>& face,
                const Level<Scalar>& level, const SampleTurns& turns);

}  // namespace tensortopo
