// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo::detail {

/// Three times the deviator.
Eigen::Matrix3d matrix_of(const Deviator<double>& t);

/// The mode at a tensor and its first and second derivatives in three directions.
struct ModeShape {
  double mode;
  Eigen::Vector3d slope;
  Eigen::Matrix3d hessian;
};

/// @param tensor, directions  as `matrix_of`; not finite where the tensor is zero
ModeShape mode_shape(const Eigen::Matrix3d& tensor,
                     const std::array<Eigen::Matrix3d, 3>& directions);

}  // namespace tensortopo::detail
