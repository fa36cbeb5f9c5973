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
/// Of ten in a row, four are general, three have a rational frame, one has a neutral and one
/// a planar degenerate characteristic tensor, and one is deficient: of a rank below 4.
Trial random_trial(std::uint64_t seed, std::size_t index);

/// The field of span orthogonal to `tensor`: a nonzero traceless one.
TetrahedronField<Rational> field_orthogonal_to(const SymmetricTensor<Rational>& tensor,
                                               Random& random);

/// Columns of the rotation of a random quaternion with integer entries.
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
