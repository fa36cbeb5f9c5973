// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The plane across a medium eigenvector v: the asymmetric tensor A(v), the boundary function Delta,
// sigma, and the tensor that belongs to v.
#include "certificates/step.hpp"
#include "steps/common/asymmetric_tensor.hpp"
#include "steps/common/general_matrices.hpp"

namespace proofs {
namespace {

Polynomial sum_of_principal_minors(const Matrix3& m) { return trace(adjugate(m)); }

std::vector<Polynomial> projected_tensor(Constants& k) {
  const UnitVector unit;
  const Vector3& v = unit.v;
  const Matrix3 t = any_traceless();
  Matrix3 projection;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      projection[i][j] = (i == j ? k(1) : Polynomial()) - v[i] * v[j];
  const Matrix3 projected = projection * t * projection;
  return {UnitVector::reduced(trace(projected) + quadratic_form(t, v)),
          UnitVector::reduced(sum_of_principal_minors(projected) - quadratic_form(adjugate(t), v)),
          UnitVector::reduced(determinant(projected))};
}

std::vector<Polynomial> plane_determinant(Constants& k) {
  // Not only for unit vectors: the form on the right is made homogeneous by |v|^2.
  const Vector3 v = UnitVector().v;
  const Matrix3 t = any_traceless();
  return {quadratic_form(adjugate(t), v) -
          (quadratic_form(t * t, v) - k(1, 2) * inner(t, t) * dot(v, v))};
}

/// d+, d- and what they make: alpha = -(d+ + d-) and, as beta - 1/2 is the product, beta.
struct PlaneEigenvalues {
  Polynomial major = variable("d+"), minor = variable("d-"), s = variable("s");
  Polynomial alpha, beta, delta;

  explicit PlaneEigenvalues(Constants& k) {
    alpha = k(-1) * (major + minor);
    beta = k(1, 2) + major * minor;
    delta = k(1, 2) - beta + k(1, 4) * (k(1) - square(s)) * square(alpha);
  }
};

std::vector<Polynomial> delta_is_difference(Constants& k) {
  const PlaneEigenvalues d(k);
  const Polynomial root_squared = k(1, 4) * square(d.major - d.minor);
  return {root_squared - (k(1, 2) - d.beta + k(1, 4) * square(d.alpha)),
          d.delta - (root_squared - square(k(1, 2) * d.s * d.alpha))};
}

std::vector<Polynomial> delta_factors(Constants& k) {
  const PlaneEigenvalues d(k);
  const Polynomial F = (k(1) - d.s) * d.major - (k(1) + d.s) * d.minor;
  const Polynomial G = (k(1) + d.s) * d.major - (k(1) - d.s) * d.minor;
  return {d.delta - k(1, 4) * F * G};
}

std::vector<Polynomial> asymmetric_discriminant(Constants& k) {
  const AsymmetricTensor a(k(1, 2));
  const Matrix2 t = restricted(), m = a.of(t);
  const Polynomial isotropic_root_squared = k(1, 4) * square(trace(t)) - determinant(t);
  return {a.reduced(k(1, 4) * square(trace(m)) - determinant(m) -
                    (isotropic_root_squared - square(k(1, 2) * a.sine(k) * trace(t))))};
}

std::vector<Polynomial> asymmetric_antipode(Constants& k) {
  const AsymmetricTensor a;
  const Matrix2 t = restricted(), left = a.opposite_of(t), right = adjugate(a.of(t));
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      differences.push_back(a.reduced(left[i][j] - k(1) * right[i][j]));
  return differences;
}

/// The plane across v in the basis d, v x d, where d is the dominant eigenvector of a tensor
/// (3+s) d d^T - 2s v v^T + (s-3) (v x d)(v x d)^T that is orthogonal to the characteristic tensor.
/// Its entries are then (1-s) n, y, (1+s) n for some n, and y is sigma.
Matrix2 in_dominant_basis(const Polynomial& s, Constants& k) {
  const auto n = variable("n"), y = variable("y");
  return {{{(k(1) - s) * n, y}, {y, (k(1) + s) * n}}};
}

std::vector<Polynomial> dominant_basis(Constants& k) {
  const auto s = variable("s");
  const Matrix2 t = in_dominant_basis(s, k);
  const Polynomial alpha = -trace(t);
  const Polynomial orthogonal = (k(3) + s) * t[0][0] + k(-2) * s * alpha + (s - k(3)) * t[1][1];
  // Delta is a difference of squares plus y^2; the difference vanishes, whatever its factor.
  const Polynomial delta =
      Polynomial(rational(1, 4)) * (square(t[0][0] - t[1][1]) - square(s * trace(t))) +
      square(variable("y"));
  return {orthogonal, delta - k(1) * square(variable("y"))};
}

std::vector<Polynomial> dominant_eigenvector(Constants& k) {
  const AsymmetricTensor a(k(1, 2));
  const Matrix2 t = in_dominant_basis(a.sine(k), k), m = a.of(t);
  return {a.reduced(m[1][0]), a.reduced(m[0][0] - (k(1, 2) * trace(m) - k(1) * variable("y")))};
}

std::vector<Polynomial> tensor_of_vector(Constants& k) {
  // In the eigenvectors of the restricted tensor: T' = diag(f + e, f - e), alpha = -2 f. The tensor
  // is l2 along v and -(l2/2) I + ((l1-l3)/2) [[c, w], [w, -c]] across it, with c = s alpha / (2 e)
  // and c^2 + w^2 = 1 as Delta = e^2 w^2. Orthogonality is multiplied by e.
  const auto e = variable("e"), f = variable("f"), s = variable("s"), c = variable("c"),
             w = variable("w");
  const Polynomial l1 = k(3) + s, l2 = k(-2) * s, l3 = s - k(3), alpha = k(-2) * f;
  const Polynomial half_gap = k(1, 2) * (l1 - l3), middle = k(-1, 2) * l2;
  const Matrix2 across{
      {{middle + half_gap * c, half_gap * w}, {half_gap * w, middle - half_gap * c}}};
  const Polynomial c_times_e = k(1, 2) * s * alpha;
  const Polynomial orthogonal =
      l2 * alpha * e + middle * k(2) * f * e + half_gap * k(2) * c_times_e * e;
  const auto reduced = [&](const Polynomial& g) {
    return g.with_square("w", Polynomial(1) - square(c));
  };
  return {orthogonal, trace(across) - (l1 + l3), reduced(determinant(across) - l1 * l3)};
}

}  // namespace

std::vector<Step> asymmetric_tensor_steps() {
  return {
      identity(Place::theorem2, "projected-tensor",
               "|v| = 1, tr T = 0, T' = (I - v v^T) T (I - v v^T): tr T' = -v.T v, "
               "second invariant v.adj(T) v, det T' = 0",
               projected_tensor),
      identity(Place::theorem2, "plane-determinant",
               "tr T = 0: v.adj(T) v = v.T^2 v - |T|^2 |v|^2 / 2", plane_determinant),
      identity(Place::theorem2, "boundary-difference",
               "alpha = -(d+ + d-), beta = 1/2 + d+ d-: Delta = 1/2 - beta + (1-s^2) alpha^2 / 4 = "
               "(d+ - d-)^2 / 4 - (s alpha / 2)^2",
               delta_is_difference),
      identity(Place::quads, "boundary-factors",
               "Delta = [(1-s) d+ - (1+s) d-] [(1+s) d+ - (1-s) d-] / 4", delta_factors),
      identity(Place::theorem2, "asymmetric-discriminant",
               "A = R(theta/2 + pi/4) T' R(theta/2 - pi/4): (tr A)^2 / 4 - det A = "
               "(tr T')^2 / 4 - det T' - (sin theta tr T' / 2)^2",
               asymmetric_discriminant),
      identity(Place::theorem1, "asymmetric-antipode",
               "R(-theta/2 - pi/4) T' R(pi/4 - theta/2) = adj(A)", asymmetric_antipode),
      identity(
          Place::theorem1, "sigma-squared",
          "<t, T-bar> = 0 for t of eigenvalues (3+s, -2s, s-3) on (d, v, v x d): d.T d = (1-s) n, "
          "(v x d).T (v x d) = (1+s) n, and Delta = (d.T (v x d))^2",
          dominant_basis),
      identity(Place::theorem1, "dominant-eigenvector",
               "then A d = (tr(A) / 2 - sigma) d with sigma = d.T (v x d)", dominant_eigenvector),
      identity(
          Place::theorem1, "tensor-of-vector",
          "-(l2/2) I + ((l1-l3)/2) [[c, w], [w, -c]], c = s alpha / (d+ - d-), c^2 + w^2 = 1, has "
          "eigenvalues l1, l3 and with l2 v v^T is orthogonal to T-bar",
          tensor_of_vector),
  };
}

}  // namespace proofs
