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

/// For a degenerate N with a multiple e of its dominant eigenvector, and another tensor: the one
/// with kernel e that is orthogonal to both; zero only if it is not unique.
///
/// It is the other tensor on the plane across e, without its trace there and turned by an eighth of
/// a turn.
template <class Scalar>
SymmetricTensor<Scalar> neutral_companion(const Vector3<Scalar>& e,
                                          const SymmetricTensor<Scalar>& other) {
  const Scalar size = dot(e, e), zero(0), one(1), two(2);
  const SymmetricTensor<Scalar> across = {size - e.x * e.x, size - e.y * e.y, size - e.z * e.z,
                                          -(e.x * e.y),     -(e.y * e.z),     -(e.x * e.z)};
  const Vector3<Scalar> unit[] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  const Vector3<Scalar> image[] = {across * (other * (across * unit[0])),
                                   across * (other * (across * unit[1])),
                                   across * (other * (across * unit[2]))};
  const Scalar part = image[0].x + image[1].y + image[2].z;
  const auto column = [&](std::size_t i) {
    return cross(e, two * size * image[i] - part * (across * unit[i]));
  };
  const Vector3<Scalar> x = column(0), y = column(1), z = column(2);
  return {x.x, y.y, z.z, x.y, y.z, x.z};
}

/// A multiple of the dominant eigenvector of a degenerate N: the image of v by the tensor of rank
/// one that N is apart from a multiple of the identity. Zero if v is orthogonal to it.
template <class Scalar>
Vector3<Scalar> dominant_direction(const SymmetricTensor<Scalar>& n, const Vector3<Scalar>& v) {
  const Scalar shift = Scalar(3) * determinant(n);
  return inner(n, n) * (n * v) + shift * v;
}

/// The non-degenerate critical points, from the complement.
struct PencilSystem {
  Position position = Position::coincident;
  /// The cubic at k N1' + N2', where N1', N2' is a basis of the complement with a zero of the cubic
  /// at neither end; square-free.
  Polynomial cubic;
  std::array<IntegerTensor, 2> basis{};
  /// The companions at those of its zeros at which N is not degenerate, and the neutral ones at the
  /// others; of the latter there are none in general. All real points are among these if `position`
  /// is general or isotropic.
  PointFamily regular, neutral;

  /// N at the zeros of the cubic.
  SymmetricTensor<Polynomial> normal() const {
    return Polynomial::variable() * tensor_cast<Polynomial>(basis[0]) +
           tensor_cast<Polynomial>(basis[1]);
  }
};
PencilSystem pencil_system(const Plane& plane);

/// The number of real zeros of det(k1 N1 + k2 N2) on the projective line, by the sign of its
/// discriminant; 0 if two coincide or all are zeros.
int neutral_normals(const Plane& plane);

}  // namespace tensortopo::theory
