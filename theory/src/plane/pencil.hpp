// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plane/critical_points.hpp"

namespace tensortopo::theory {

/// The traceless tensor that commutes with N and is orthogonal to it, times |N|^2: zero exactly for
/// degenerate N.
template <class Scalar>
SymmetricTensor<Scalar> companion(const SymmetricTensor<Scalar>& n) {
  const SymmetricTensor<Scalar> n2 = square(n);
  const Scalar size = inner(n, n), cube = inner(n2, n);
  // Thrice, so that no number is divided.
  const Scalar three(3), shift = -(size * size);
  const SymmetricTensor<Scalar> identity = {Scalar(1), Scalar(1), Scalar(1),
                                            Scalar(0), Scalar(0), Scalar(0)};
  return three * size * n2 + shift * identity + (-(three * cube)) * n;
}

/// For N = k1 N1 + k2 N2, the complement's basis: tr(N^2 N1) <N, N2> - tr(N^2 N2) <N, N1>, which is
/// zero if the companion of N lies in the plane.
template <class Scalar>
Scalar pencil_cubic(const SymmetricTensor<Scalar>& n, const SymmetricTensor<Scalar>& n1,
                    const SymmetricTensor<Scalar>& n2) {
  const SymmetricTensor<Scalar> squared = square(n);
  return inner(squared, n1) * inner(n, n2) - inner(squared, n2) * inner(n, n1);
}

/// For a degenerate N, N' and a multiple e of its dominant eigenvector: the tensor with kernel e
/// that is orthogonal to N and N'; zero only if it is not unique.
///
/// It is N' on the plane across e, without its trace there and turned by an eighth of a turn.
IntegerTensor neutral_companion(const Vector3<Integer>& e, const IntegerTensor& other);

/// A column of the rank-one tensor that a degenerate N is apart from a multiple of the identity.
Vector3<Integer> dominant_direction(const IntegerTensor& degenerate);

/// The non-degenerate critical points, from the complement.
struct PencilSystem {
  Position position = Position::coincident;
  /// The cubic at k N1' + N2', where N1', N2' is a basis of the complement with a zero of the cubic
  /// at neither end; square-free.
  Polynomial cubic;
  std::array<IntegerTensor, 2> basis{};
  /// The zeros of the cubic at which N is not degenerate, and the companions there.
  PointFamily regular;
  /// Critical tensors that belong to a degenerate N; there is none in general. Nothing is said about
  /// pairs of such N of which neither is rational: then `position` is not general.
  std::vector<IntegerTensor> neutral;

  /// N at the zeros of the cubic.
  SymmetricTensor<Polynomial> normal() const {
    return Polynomial::variable() * lifted<Polynomial>(basis[0]) + lifted<Polynomial>(basis[1]);
  }
};
PencilSystem pencil_system(const Plane& plane);

/// What the real ones are.
std::vector<CriticalKind> real_points(const Plane& plane, const PencilSystem& pencil);

/// The number of real zeros of det(k1 N1 + k2 N2) on the projective line, by the sign of its
/// discriminant; 0 if two coincide or all are zeros.
int neutral_normals(const Plane& plane);

}  // namespace tensortopo::theory
