// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/topology/boundary/face_curves.hpp"

namespace tensortopo {

/// Samples the arc so that neither the medium eigenvector nor the tensor turns too far from one
/// sample to the next.
template <class Scalar>
void sample_arc(FaceArc<Scalar>& arc, const std::array<Deviator<Scalar>, 3>& face,
                const Level<Scalar>& level, const Sampling& sampling);

}  // namespace tensortopo
