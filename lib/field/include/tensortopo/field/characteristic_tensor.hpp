// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Dimension of the span of a field's vertex deviators, 0 to 4, by exact elimination.
///
/// Below 4 the characteristic tensor is not unique and the medium eigenvectors do not parameterise
/// the mode surfaces: rank 3 gives cylinders or cones, rank 2 pencils of planes, rank 1 a constant
/// mode, rank 0 none. A field with a symmetry plane or in plane strain never exceeds 3.
template <FieldScalar Scalar>
requires(ScalarTraits<Scalar>::is_exact) int field_rank(const TetrahedronField<Scalar>& field);

/// The rank of the deviators of tensors given in doubles, decided without error.
///
/// A double filter with a proved bound settles almost every field of rank 4; rational elimination
/// the rest. Throws std::invalid_argument if an entry is not finite.
int exact_rank(const std::array<SymmetricTensor<double>, 4>& tensors);

/// The same for any number of tensors (a face has three); always by elimination.
int exact_rank(std::span<const SymmetricTensor<double>> tensors);

/// A deviator orthogonal to the four vertex deviators: their generalized cross product.
///
/// Exact over exact scalars: `norm_form` with each vertex deviator is zero. Not normalised; zero
/// iff the rank is below 4. Over ordered fields its sign is such that its determinant is <= 0; an
/// enclosure cannot order signs and keeps the sign of the cross product.
template <FieldScalar Scalar>
Deviator<Scalar> characteristic_direction(const TetrahedronField<Scalar>& field);

/// The characteristic tensor of a linear field of rank 4 (paper, definition of T-bar) in full.
template <RealScalar Scalar>
struct CharacteristicTensor {
  /// Unit, traceless, of determinant <= 0, orthogonal to the field.
  SymmetricTensor<Scalar> tensor{};
  /// In descending order; the medium one is >= 0.
  std::array<Scalar, 3> eigenvalues{};
  /// Orthonormal and right-handed, in the order of the eigenvalues.
  std::array<Vector3<Scalar>, 3> eigenvectors{};
  /// In [-1, 0].
  Scalar mode{};
};

/// The characteristic tensor, or nothing if the rank of the field is below 4.
///
/// The rank is that of the given scalars taken as exact numbers. A well-conditioned field is solved
/// by elimination with complete pivoting; where a pivot is small (or zero) the cross product is
/// taken in rationals and rounded at the end, so that a nearly deficient field costs time and not
/// digits. A neutral or degenerate one is recognised
/// exactly: its medium eigenvalue and mode are then 0, or its two largest eigenvalues equal and its
/// mode -1. If the determinant is zero, both signs satisfy the definition and one of them is
/// returned.
template <RealScalar Scalar>
std::optional<CharacteristicTensor<Scalar>> characteristic_tensor(
    const TetrahedronField<Scalar>& field);

}  // namespace tensortopo
