// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"
#include "tensortopo/theory/random.hpp"

namespace tensortopo::theory {

/// An orthonormal and right-handed basis with rational entries.
using Basis = std::array<Vector3<Rational>, 3>;

/// Eigenvalues and eigenvectors of a tensor orthogonal to a field. Most tensors have none that are
/// rational; fields made from them let statements about eigenvalues be decided exactly.
struct Frame {
  std::array<Rational, 3> eigenvalues{};  ///< descending, of sum zero, the medium one >= 0
  Basis eigenvectors{};
  /// (A, B) with A^2 = (l1 - l2) / (l1 - l3) and B^2 = (l2 - l3) / (l1 - l3), where these are
  /// rational: A e1 + B e3 and -A e1 + B e3 are then the singularities.
  std::optional<std::array<Rational, 2>> singular;
};

/// A linear field on which statements are tried, and a source of further choices.
struct Trial {
  /// The tensors at the vertices of a tetrahedron. T_0 + x T_x + y T_y + z T_z has the same span.
  TetrahedronField<Rational> field;
  /// Known for some fields of rank 4.
  std::optional<Frame> frame;
  /// For points, vectors and mode values; a check works on a copy.
  Random random{0};
};

/// Field number `index` of a seed; the same everywhere, whatever else is tried.
///
/// Of ten in a row, four are general, three have a rational frame (one of them with rational
/// singularities), one has a neutral and one a planar degenerate characteristic tensor, and one is
/// deficient: of a rank below 4.
Trial random_trial(std::uint64_t seed, std::size_t index);

/// The field of span orthogonal to `tensor`: a nonzero traceless one.
TetrahedronField<Rational> field_orthogonal_to(const SymmetricTensor<Rational>& tensor,
                                               Random& random);

/// Columns of the rotation of a quaternion, which need not be of norm 1. Requires it nonzero.
Basis basis_of_quaternion(const std::array<int, 4>& quaternion);

/// The same of a random quaternion.
Basis random_basis(Random& random);

/// Traceless tensor with these eigenvalues, of sum zero, and eigenvectors.
SymmetricTensor<Rational> tensor_of(const std::array<Rational, 3>& eigenvalues, const Basis& basis);

/// The traceless tensor at a random point of the tetrahedron's space.
SymmetricTensor<Rational> tensor_at_random_point(const Trial& trial, Random& random);

/// Components in the order xx, yy, zz, xy, yz, xz, as fractions.
std::string text(const SymmetricTensor<Rational>& tensor);
std::string text(const Vector3<Rational>& vector);
/// The traceless tensors at the four vertices.
std::string text(const TetrahedronField<Rational>& field);

}  // namespace tensortopo::theory
