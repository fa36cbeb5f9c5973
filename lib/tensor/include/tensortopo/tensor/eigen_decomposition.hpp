// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Eigenvalues in descending order (major, medium, minor) with orthonormal, right-handed
/// eigenvectors.
template <RealScalar Scalar>
struct Eigensystem {
  std::array<Scalar, 3> values{};            ///< the largest one first
  std::array<Vector3<Scalar>, 3> vectors{};  ///< of unit length, sign arbitrary
};

/// Eigensystem of a symmetric tensor by Jacobi rotations.
///
/// Never fails for finite entries; eigenvalues are accurate to a few ulp of the tensor's magnitude,
/// and the vectors are orthonormal to a few ulp whether or not eigenvalues repeat. Each vector's
/// sign is such that the first two have their component of largest magnitude positive; the third
/// follows from the handedness.
template <RealScalar Scalar>
Eigensystem<Scalar> eigen_decomposition(const SymmetricTensor<Scalar>& tensor);

}  // namespace tensortopo
