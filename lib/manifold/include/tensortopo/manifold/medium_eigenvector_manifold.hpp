// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Sphero-conal coordinates of a unit vector: theta in [0, 2 pi), eta in [0, pi], in radians.
/// The antipode of (theta, eta) is (theta + pi, pi - eta), and (theta, eta) and (-theta, -eta) are
/// one point, so eta = 0 and eta = pi are cuts between two singularities, each of whose points has
/// two names.
template <RealScalar Scalar>
struct SpheroConal {
  /// In radians.
  Scalar theta{}, eta{};
};

/// Sines and cosines of sphero-conal coordinates.
template <RealScalar Scalar>
struct SpheroConalSines {
  Scalar sin_theta{};  ///< of theta
  Scalar cos_theta{};  ///< of theta
  Scalar sin_eta{};    ///< of eta
  Scalar cos_eta{};    ///< of eta
};

/// A point of the boundary of the complex domain, modulo the antipodal map.
template <RealScalar Scalar>
struct BoundaryPosition {
  /// 0 .. loop_count() - 1.
  int loop = 0;
  /// Angle in [0, 2 pi).
  Scalar phi{};
  /// 1 if boundary_point(loop, phi) is the vector itself, -1 if it is its antipode.
  int sign = 1;
};

/// The sphere of medium eigenvectors of a linear field of rank 4, for one |mode|.
///
/// Let b1 >= b2 >= b3 be the eigenvalues of the characteristic tensor (b2 >= 0), s >= 0 the sine of
/// the mode parameter. A unit vector v is the medium eigenvector of a field tensor of mode +mu or
/// -mu iff `boundary_function`(v) >= 0 (the real domain, Theorem 2). Then v has one tensor, and -v
/// the other one with the same medium eigenvector line; on the boundary both coincide.
///
/// Everything is computed from the singularities s1, s2 = A e1 + B e3, -A e1 + B e3 because
/// T-bar = b2 I - (b1 - b3)/2 (s1 s2^T + s2 s1^T): for v near a singularity differences of vectors
/// are then formed before they are multiplied, so that also next to it (where the complex domain of
/// a small mode hides) the tensors have exactly the mode and the medium eigenvector asked for.
///
/// All vectors v are unit vectors in the coordinates of the field unless said otherwise.
template <RealScalar Scalar>
class MediumEigenvectorManifold {
 public:
  /// Of a field of rank 4, by its characteristic tensor, and a mode.
  MediumEigenvectorManifold(const CharacteristicTensor<Scalar>& characteristic,
                            const ModeParameter<Scalar>& mode);

  /// The field's characteristic tensor.
  const CharacteristicTensor<Scalar>& characteristic() const { return characteristic_; }
  /// The mode.
  const ModeParameter<Scalar>& mode() const { return mode_; }

  /// Delta(v) = 1/2 - v.T^2 v + cos^2(theta) (v.T v)^2 / 4 with T the characteristic tensor
  /// (Theorem 2). Positive inside the real domain, zero on the boundary, negative in the complex
  /// domain; even in v.
  Scalar boundary_function(const Vector3<Scalar>& v) const;
  /// Whether boundary_function(v) >= 0.
  bool in_real_domain(const Vector3<Scalar>& v) const;

  /// The unit tensor of mode +|mu| with medium eigenvector v, orthogonal to the characteristic
  /// tensor, whose major eigenvector is the major eigenvector of A(v); -v gives the one of the
  /// minor eigenvector.
  ///
  /// The field tensor is a positive or negative multiple (see FieldLift): positive where the field
  /// has mode +|mu|. Requires v in the real domain; outside, to be kind to rounding, the answer is
  /// tensor_at_boundary(v). At mu = 0, v must not be a singularity.
  SymmetricTensor<Scalar> tensor_at(const Vector3<Scalar>& v) const;
  /// The limit of `tensor_at` on the boundary: free of the root that makes the fold there.
  SymmetricTensor<Scalar> tensor_at_boundary(const Vector3<Scalar>& v) const;

  /// sigma(v, d) = d . T (v x d) for unit vectors v and d, d orthogonal to v.
  ///
  /// For a field tensor of mode +-mu with medium eigenvector v and dominant eigenvector d:
  /// sigma^2 = boundary_function(v), and v is the canonical one of +-v (tensor_at(v) has dominant
  /// eigenvector d) iff sigma <= 0. Odd in v. On a mode curve it crosses zero with a sign change
  /// where the curve reaches the boundary, while boundary_function has a double zero.
  Scalar sigma(const Vector3<Scalar>& v, const Vector3<Scalar>& d) const;

  /// The dominant eigenvector of tensor_at(v): a unit vector orthogonal to v, up to sign.
  Vector3<Scalar> dominant_eigenvector(const Vector3<Scalar>& v) const;

  /// {d+, d-}: the eigenvalues of the characteristic tensor restricted to the plane across v, in
  /// [b2, b1] and [b3, b2]. d+ = b2 + (b1 - b2) sin^2 theta, d- = b2 - (b2 - b3) sin^2 eta.
  std::array<Scalar, 2> plane_eigenvalues(const Vector3<Scalar>& v) const;

  /// The vectors A e1 + B e3 and -A e1 + B e3: with their antipodes, the directions across which
  /// the characteristic tensor is isotropic. A^2 = (b1 - b2)/(b1 - b3), B^2 = (b2 - b3)/(b1 - b3).
  const std::array<Vector3<Scalar>, 2>& singularities() const { return singularities_; }

  /// The unit vector with these coordinates (any real numbers):
  /// x = cos theta sqrt(1 - B^2 cos^2 eta), y = sin theta sin eta, z = cos eta sqrt(1 - A^2 cos^2
  /// theta) along the characteristic eigenvectors. The coordinate lines are orthogonal.
  Vector3<Scalar> sphere_point(const Scalar& theta, const Scalar& eta) const;
  /// The same from the sines and cosines of the coordinates.
  Vector3<Scalar> sphere_point(const SpheroConalSines<Scalar>& at) const;
  /// Coordinates of a unit vector. On the cuts eta = 0 and eta = pi, theta in [0, pi] is chosen.
  SpheroConal<Scalar> sphero_conal(const Vector3<Scalar>& v) const;
  /// Their sines and cosines, without an angle.
  SpheroConalSines<Scalar> sphero_conal_sines(const Vector3<Scalar>& v) const;

  /// F = p sin^2 theta + q sin^2 eta - c, of the sign of boundary_function: the boundary is a
  /// straight segment in (sin^2 theta, sin^2 eta). Delta = F G / 4 with G = (1 + s) d+ - (1 - s) d-
  /// >= 0.
  Scalar F(const Scalar& theta, const Scalar& eta) const;
  /// (1 - s)(b1 - b2).
  const Scalar& p() const { return p_; }
  /// (1 + s)(b2 - b3), always > c.
  const Scalar& q() const { return q_; }
  /// 2 s b2.
  const Scalar& c() const { return c_; }

  /// Whether |mu| is above the bifurcation sqrt(1 - mode(T-bar)^2): two antipodal components of the
  /// complex domain (c > p) instead of four.
  bool single_loop() const { return c_ > p_; }
  /// Whether the complex domain is empty: mu = 0 or mode(T-bar) = 0. Boundary loops are then
  /// points.
  bool complex_domain_empty() const { return !(c_ > Scalar(0)); }
  /// Boundary curves modulo the antipodal map: 1 if single_loop(), else 2.
  int loop_count() const { return single_loop() ? 1 : 2; }

  /// A regular, 2 pi periodic parameterization of a boundary curve; the curves on z > 0 of the
  /// characteristic eigenvector frame, the others being their antipodes.
  ///
  /// Single loop: theta = phi, q sin^2 eta = c - p sin^2 theta. Two loops, around theta = 0 and
  /// theta = pi: sqrt(p) sin theta = +-sqrt(c) cos(phi/2), sqrt(q) sin eta = sqrt(c) sin(phi/2).
  /// Exactly at the bifurcation (c = p) the two ovals touch, and the second description holds.
  Vector3<Scalar> boundary_point(int loop, const Scalar& phi) const;
  /// Inverse of `boundary_point` modulo the antipodal map; a v beside the boundary is read as if
  /// moved along the direction that keeps phi.
  BoundaryPosition<Scalar> boundary_position(const Vector3<Scalar>& v) const;
  /// The angle of boundary_position(v).
  Scalar boundary_parameter(const Vector3<Scalar>& v) const { return boundary_position(v).phi; }
  /// The loop of boundary_position(v).
  int boundary_loop(const Vector3<Scalar>& v) const { return boundary_position(v).loop; }

 private:
  struct Tangents;
  Tangents tangents(const Vector3<Scalar>& v) const;
  SymmetricTensor<Scalar> assemble(const Vector3<Scalar>& v, const Tangents& a,
                                   const Scalar& cosine, const Scalar& sine) const;
  Vector3<Scalar> in_frame(const Vector3<Scalar>& v) const;

  CharacteristicTensor<Scalar> characteristic_;
  ModeParameter<Scalar> mode_;
  std::array<Vector3<Scalar>, 2> singularities_;
  Scalar A_, B_, p_, q_, c_;
};

}  // namespace tensortopo
