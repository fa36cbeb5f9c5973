// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "analyze/curvature/level_curvature.hpp"
#include "analyze/curvature/level_form.hpp"

namespace tensortopo {

/// How the principal curvatures of a level of the mode change along their own directions.
template <class Scalar>
struct LevelExtremality {
  LevelCurvature<Scalar> curvature;
  /// The derivative of each principal curvature along its direction, in 1 / length^2; it changes
  /// its sign with the direction's. Without meaning at an umbilic.
  std::array<Scalar, 2> extremality{};
  /// What the sizes of its terms allow; see `is_flat`.
  Scalar largest{};

  /// No more than rounding: below 2^-40 of what its terms may be.
  bool is_flat(std::size_t which) const;
};

/// The derivative of the principal curvature k along its unit direction t, for the zero set of F
/// with unit normal n = grad F / |grad F|:
///   e = (D3F(t, t, t) - 3 k D2F(t, n)) / |grad F|.
/// (O. Monga, S. Benayoun and O. Faugeras, 1992; Y. Ohtake, A. Belyaev and H.-P. Seidel,
/// Ridge-valley lines on meshes via implicit surface fitting, 2004, whose curvatures have the other
/// sign. The derivative of t^t W t, W = P D2F P / |grad F| with P = I - n n^t, along t: as t is an
/// eigenvector its own change plays no part, that of n is k t, and that of |grad F| D2F(t, n).)
/// @param third  D3F(t, t, t)
template <RealScalar Scalar>
Scalar extremality(const LevelCurvature<Scalar>& curvature, std::size_t which,
                   const Scalar& steepness, const SymmetricTensor<Scalar>& hessian,
                   const Scalar& third);

/// At any point of the linear field of a tetrahedron.
/// @return nothing where `level_curvature` returns nothing
template <RealScalar Scalar>
std::optional<LevelExtremality<Scalar>> level_extremality(
    const std::array<Vector3<Scalar>, 4>& corners,
    const std::array<SymmetricTensor<Scalar>, 4>& tensors, const Vector3<Scalar>& point);

}  // namespace tensortopo
